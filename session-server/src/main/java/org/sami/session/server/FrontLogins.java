package org.sami.session.server;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.LongSupplier;
import org.eclipse.jetty.websocket.api.StatusCode;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.session.Session;
import org.sami.session.person.People;
import org.sami.session.person.Person;

/** Who takes part at each front: login by name and key, changes of the role, removal. On the server's thread. */
final class FrontLogins {
    /** Interval of the heartbeats that are sent to fronts that are logged in, in ms; the message {@code welcome} names it. */
    static final long BEAT_MS = 500;

    private static final int VERSION = 1;

    private final Session session;
    private final People people;
    private final RobotKind robots;
    private final Tickets tickets;
    private final FailedLogins failedLogins;
    private final Executor thread;

    /**
     * Logins of a session; there has been none.
     *
     * @param nanos a clock that only goes on, in ns
     * @param thread the server's
     */
    FrontLogins(
            Session session, People people, RobotKind robots, Tickets tickets, LongSupplier nanos, Executor thread) {
        this.session = session;
        this.people = people;
        this.robots = robots;
        this.tickets = tickets;
        failedLogins = new FailedLogins(nanos);
        this.thread = thread;
    }

    /** Logs a front's person in; otherwise refuses the front and ends its connection. */
    void hello(Front front, FrontMessage message) {
        String name;
        String key;
        try {
            if (message.number("v") != VERSION) {
                refuseLogin(front, "this server speaks version " + VERSION + " of the link, and no other");
                return;
            }
            name = message.text("name");
            key = message.textIfThere("key").orElse("");
        } catch (MalformedMessageException wrong) {
            front.malformed(0, wrong);
            return;
        }
        Optional<String> refusal = people.needKeys() ? failedLogins.refusal(front.address()) : Optional.empty();
        if (refusal.isPresent()) {
            refuseLogin(front, refusal.get());
            return;
        }
        Optional<Person> person = people.login(name, key);
        if (person.isPresent()) {
            welcome(front, person.get());
        } else if (!people.needKeys()) {
            refuseLogin(front, "a name has 1 to 40 letters, digits, '-', '_' or '.'");
        } else {
            failedLogins.note(front.address());
            refuseLogin(front, "no such name and key");
        }
    }

    private static void refuseLogin(Front front, String why) {
        front.refuse(0, why);
        front.end(StatusCode.POLICY_VIOLATION, "not let in");
    }

    private void welcome(Front front, Person person) {
        session.begun()
                .thenCompose(
                        begun -> session.ask(view -> List.copyOf(view.project().plans())))
                .thenCompose(plans -> session.models().shown().thenApply(shown -> plans)) // what was open is there
                .thenAccept(plans -> thread.execute(() -> {
                    if (front.hasEnded()) {
                        return;
                    }
                    front.send(PersonMessages.welcome(person, VERSION, robots.word(), plans)
                            .put("now", session.scheduler().nowMs())
                            .put("epoch", session.setup().journal().epoch())
                            .put("beat", BEAT_MS)
                            .put("ticket", tickets.issue(front))
                            .toString());
                    front.login(person);
                }));
    }

    /** Puts a person down as listed now; tells its front of another role. */
    static void listed(Front front, Person earlier, Person now) {
        front.login(now);
        if (now.role() != earlier.role()) {
            front.send(PersonMessages.rights(now).toString());
        }
    }

    /** Ends the connection of a person who was removed. */
    static void bye(Front front) {
        front.send(PersonMessages.bye(front.name()).toString());
        front.end(StatusCode.POLICY_VIOLATION, "removed");
    }
}
