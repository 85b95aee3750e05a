//! A robot for tests: the action `/fly`, the service `/arm`, the topics `/battery` and `/say`. The number in a goal says
//! how it ends. What happens is a line of the standard output; `decide` on the input lets goals of LATE be accepted, a
//! number there is the battery's charge.

use std::io::{BufRead, Write};
use std::net::Ipv4Addr;
use std::time::Duration;

use futures::{pin_mut, select, FutureExt, StreamExt};
use ros2_client::action::{ActionServerQosPolicies, AsyncActionServer, ExecutingGoalHandle, GoalEndStatus};
use ros2_client::qos::{Durability, History};
use ros2_client::{
    ActionTypeName, Context, Message, MessageTypeName, Name, Node, NodeName, NodeOptions, Publisher, QosProfile, Server,
    NodeEvent, ServiceMapping, ServiceTypeName, Subscription,
};
use serde::{Deserialize, Serialize};
use smol::channel::{unbounded, Receiver};

const SUCCEED: i32 = 0;
const WAIT: i32 = 1;
const ABORT: i32 = 2;
const REJECT: i32 = 3;
const LATE: i32 = 4;

#[derive(Clone, Debug, Serialize, Deserialize)]
struct SetBoolRequest {
    data: bool,
}
impl Message for SetBoolRequest {}

#[derive(Clone, Debug, Serialize, Deserialize)]
struct SetBoolResponse {
    success: bool,
    message: String,
}
impl Message for SetBoolResponse {}

/// The goal has a string before its numbers, so that their alignment counts.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Goal {
    name: String,
    how: i32,
    height: f64,
}
impl Message for Goal {}

type Actions = AsyncActionServer<Goal, Vec<i32>, Vec<i32>>;

fn say(text: String) {
    println!("{text}");
    std::io::stdout().flush().unwrap();
}

fn quality(durability: Durability) -> QosProfile {
    QosProfile::publisher_default().durability(durability).history(History::KeepLast { depth: 10 })
}

fn node(domain: u16) -> Node {
    let participant = rustdds::DomainParticipantBuilder::new(domain)
        .with_only_networks([Ipv4Addr::LOCALHOST])
        .build()
        .unwrap();
    let context = Context::from_domain_participant(participant).unwrap();
    context.new_node(NodeName::new("/", "independent").unwrap(), NodeOptions::new()).unwrap()
}

fn action_server(node: &mut Node) -> Actions {
    let volatile = || quality(Durability::Volatile);
    let qos = ActionServerQosPolicies {
        goal_service: volatile(),
        result_service: volatile(),
        cancel_service: volatile(),
        feedback_publisher: volatile(),
        status_publisher: quality(Durability::TransientLocal),
    };
    let server = node
        .create_action_server(
            ServiceMapping::Enhanced,
            &Name::new("/", "fly").unwrap(),
            &ActionTypeName::new("test_msgs", "Fly"),
            qos,
        )
        .unwrap();
    AsyncActionServer::new(server)
}

/// Accepts goals one after another, and ends each as it says.
async fn serve_goals(server: Actions, decisions: Receiver<()>) {
    loop {
        let received = server.receive_new_goal().await.unwrap();
        let goal = server.get_new_goal(received.clone()).unwrap();
        say(format!("goal {} {} {}", goal.how, goal.name, goal.height));
        if goal.how == REJECT {
            server.reject_goal(received).await.unwrap();
            continue;
        }
        if goal.how == LATE {
            decisions.recv().await.unwrap();
        }
        let accepted = server.accept_goal(received).await.unwrap();
        let executing = server.start_executing_goal(accepted).await.unwrap();
        say(format!("accepted {}", goal.how));
        let status = match goal.how {
            SUCCEED => GoalEndStatus::Succeeded,
            ABORT => GoalEndStatus::Aborted,
            WAIT | LATE => wait_for_cancel(&server, executing.clone()).await,
            _ => panic!("there is no goal {}", goal.how),
        };
        let result = vec![goal.how, 7];
        server.send_result_response(executing, status, result).await.unwrap();
        say(format!("ended {}", goal.how));
    }
}

/// Publishes feedback meanwhile.
async fn wait_for_cancel(server: &Actions, executing: ExecutingGoalHandle<Goal>) -> GoalEndStatus {
    let mut beat = StreamExt::fuse(smol::Timer::interval(Duration::from_millis(20)));
    loop {
        let cancel = server.receive_cancel_request().fuse();
        pin_mut!(cancel);
        select! {
            handle = cancel => {
                let handle = handle.unwrap();
                let id = executing.goal_id();
                let ours = handle.contains_goal(&id).then_some(id);
                server.respond_to_cancel_requests(&handle, ours.into_iter()).await.unwrap();
                if ours.is_some() {
                    return GoalEndStatus::Canceled;
                }
            }
            _ = beat.select_next_some() => server.publish_feedback(executing.clone(), vec![1, 2]).await.unwrap(),
        }
    }
}

async fn serve_arm(server: Server<SetBoolRequest, SetBoolResponse>) {
    loop {
        let (id, request) = server.async_receive_request().await.unwrap();
        let response = SetBoolResponse { success: !request.data, message: "no".into() };
        server.async_send_response(id, response).await.unwrap();
    }
}

async fn hear(texts: Subscription<String>) {
    let mut all = Box::pin(texts.async_stream());
    while let Some(Ok((text, _))) = all.next().await {
        say(format!("said {text}"));
    }
}

async fn measure(battery: Publisher<f32>, charges: Receiver<f32>) {
    let mut charge = charges.recv().await.unwrap();
    loop {
        battery.publish(charge).unwrap();
        smol::Timer::after(Duration::from_millis(50)).await;
        while let Ok(newer) = charges.try_recv() {
            charge = newer;
        }
    }
}

/// Nodes that appear, as `ros2 node list` finds them.
async fn watch(node: &Node) {
    let events = node.status_receiver().unwrap();
    while let Ok(event) = events.recv().await {
        if let NodeEvent::ParticipantEntities(participant) = event {
            for each in participant.nodes() {
                say(format!("node {}", each.fully_qualified_name()));
            }
        }
    }
}

fn main() {
    let domain = std::env::var("ROS_DOMAIN_ID").unwrap().parse().unwrap();
    let mut node = node(domain);
    let (qos, root) = (quality(Durability::Volatile), |name| Name::new("/", name).unwrap());
    let actions = action_server(&mut node);
    let set_bool = ServiceTypeName::new("std_srvs", "SetBool");
    let arm = node.create_server(ServiceMapping::Enhanced, &root("arm"), &set_bool, qos.clone(), qos.clone()).unwrap();
    let topic = node.create_topic(&root("say"), MessageTypeName::new("std_msgs", "String"), &qos).unwrap();
    let texts = node.create_subscription::<String>(&topic, None).unwrap();
    let topic = node.create_topic(&root("battery"), MessageTypeName::new("std_msgs", "Float32"), &qos).unwrap();
    let battery = node.create_publisher::<f32>(&topic, None).unwrap();
    let (decide, decisions) = unbounded();
    let (charge, charges) = unbounded();
    std::thread::spawn(move || {
        for line in std::io::stdin().lock().lines().map_while(Result::ok) {
            match line.parse::<f32>() {
                Ok(value) => charge.try_send(value).unwrap(),
                Err(_) => decide.try_send(()).unwrap(),
            }
        }
        std::process::exit(0);
    });
    smol::spawn(node.spinner().unwrap().spin()).detach();
    say("ready".into());
    smol::block_on(async {
        futures::join!(serve_goals(actions, decisions), serve_arm(arm), hear(texts), measure(battery, charges), watch(&node));
    });
}
