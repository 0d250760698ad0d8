package org.sami.session.server;

import java.io.IOException;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.eclipse.jetty.websocket.api.StatusCode;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.session.Session;
import org.sami.session.api.RefusedException;
import org.sami.session.person.People;
import org.sami.session.person.Person;
import org.sami.session.person.Right;
import org.sami.session.rows.SessionRows;
import org.sami.session.rows.Table;

/** The fronts of a session: logins, commands, rows ten times a second. Everything here is done on one thread, the server's. */
final class Fronts implements AutoCloseable {
    static final int MOST = 32;

    private static final long TICK_MS = 100;
    private static final int TICKS_PER_SECOND = 10;
    private static final long PING_MS = 15_000;
    private static final long SILENT_MS = 45_000;
    private static final long HELLO_MS = 10_000;

    private final Session session;
    private final People people;
    private final Table bases;
    private final Tickets tickets;
    private final LongSupplier nanos;
    private final SettledDecisions settled = new SettledDecisions();
    private final Set<Front> open = new LinkedHashSet<>();
    private final FrontLogins logins;
    private final SessionRows rows;
    private final HandDriving hand;
    private final JournalFeed feed;
    private final Following following;
    private final FrontCommands commands;
    private final PeopleNews news;
    private final PeopleWatch peopleWatch;
    private final ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor(work -> {
        Thread one = new Thread(work, "session server");
        one.setDaemon(true);
        return one;
    });
    private long ticks;

    /** Fronts of a session; none is connected. */
    Fronts(Session session, People people, RobotKind robots, SessionBases bases, Tickets tickets, LongSupplier nanos) {
        this.session = session;
        this.people = people;
        this.bases = bases.table();
        this.tickets = tickets;
        this.nanos = nanos;
        logins = new FrontLogins(session, people, robots, tickets, nanos, this::execute);
        news = new PeopleNews(session, this::sendToAll);
        peopleWatch = new PeopleWatch(people, session.models().health());
        rows = new SessionRows(session, this::execute);
        hand = new HandDriving(session, news);
        feed = new JournalFeed(session);
        following = new Following(session, feed, this::execute);
        commands = new FrontCommands(session, settled, hand, news);
    }

    /** Tells all fronts what somebody does. */
    PeopleNews news() {
        return news;
    }

    /**
     * Begins; before the session does.
     *
     * @throws IOException if the session's journal cannot be read
     */
    void start() throws IOException {
        feed.start();
        rows.start();
        session.execute(() -> session.addOperator(settled));
        var unused = thread.scheduleAtFixedRate(() -> guarded(this::tick), TICK_MS, TICK_MS, TimeUnit.MILLISECONDS);
    }

    private void guarded(Runnable work) {
        try {
            work.run();
        } catch (RuntimeException | Error fault) {
            session.faults().guard().uncaughtException(Thread.currentThread(), fault);
        }
    }

    private void execute(Runnable work) {
        try {
            thread.execute(() -> guarded(work));
        } catch (RejectedExecutionException over) {
            // the server has been closed
        }
    }

    Front connect(String address) {
        return new Connection(address).front;
    }

    /** What happens to one front. */
    private final class Connection implements FrontListener {
        private final Front front;

        Connection(String address) {
            front = new Front(this, address, nanos);
        }

        @Override
        public void opened() {
            Fronts.this.opened(front);
        }

        @Override
        public void received(FrontMessage message) {
            take(front, message);
        }

        @Override
        public void closed() {
            Fronts.this.closed(front);
        }
    }

    private void opened(Front front) {
        execute(() -> {
            if (open.size() >= MOST) {
                front.end(StatusCode.TRY_AGAIN_LATER, "there are " + MOST + " fronts already");
            } else if (!front.hasEnded()) {
                open.add(front);
            }
        });
    }

    private void closed(Front front) {
        execute(() -> {
            tickets.revoke(front);
            if (open.remove(front)) {
                following.left(front);
                hand.left(front);
            }
        });
    }

    private void take(Front front, FrontMessage message) {
        execute(() -> {
            if (front.hasEnded()) {
                return;
            }
            Optional<Person> person = front.person();
            if (message.type().equals("hello") && person.isEmpty()) {
                logins.hello(front, message);
            } else if (person.isEmpty()) {
                front.refuse(message.id(), "say hello first, with name and key");
                front.end(StatusCode.POLICY_VIOLATION, "no hello");
            } else {
                command(front, person.get(), message);
            }
        });
    }

    private void command(Front front, Person earlier, FrontMessage message) {
        Optional<Person> person = people.present(earlier);
        if (person.isEmpty()) {
            FrontLogins.bye(front);
            return;
        }
        listed(front, earlier, person.get());
        try {
            CompletionStage<CommandReply> carriedOut = message.type().equals("follow")
                    ? following.follow(front, message)
                    : commands.carryOut(front, person.get(), message);
            carriedOut.whenComplete((reply, fault) -> {
                if (fault == null) {
                    execute(() -> following.afterAll(front, () -> front.done(message.id(), reply)));
                } else {
                    front.refuse(message.id(), RefusedException.reason(fault));
                }
            });
        } catch (RefusedException refused) {
            front.refuse(message.id(), RefusedException.reason(refused));
        } catch (MalformedMessageException wrong) {
            front.malformed(message.id(), wrong);
        }
    }

    /** Who may drive no longer gives back the boats that were driven. */
    private void listed(Front front, Person earlier, Person now) {
        FrontLogins.listed(front, earlier, now);
        if (earlier.may(Right.DRIVE) && !now.may(Right.DRIVE)) {
            hand.left(front);
        }
    }

    private void sendToAll(String text) {
        execute(() -> open.stream().filter(front -> front.person().isPresent()).forEach(front -> front.send(text)));
    }

    private void tick() {
        ticks++;
        if (ticks % TICKS_PER_SECOND == 0) {
            List.copyOf(open).forEach(this::lookAfter);
            peopleWatch.look();
        }
        feed.takeUp();
        long now = session.scheduler().nowMs();
        hand.look(now);
        List<Front> ready = open.stream()
                .filter(front -> front.person().isPresent() && front.outbox().isIdle())
                .toList();
        if (ready.isEmpty()) {
            return;
        }
        if (ticks % (FrontLogins.BEAT_MS / TICK_MS) == 0) {
            String beat = PersonMessages.beat(now).toString();
            ready.forEach(front -> front.send(beat));
        }
        rows.look(now, hand.drivers());
        Table present = PeopleRows.of(open);
        for (Front front : ready) {
            front.person().ifPresent(person -> {
                following.send(front);
                List<Table> tables = rows.tables(person);
                tables.add(present);
                tables.add(bases);
                tables.removeIf(table -> !following.needs(front, table));
                front.rows().changes(tables, now).ifPresent(message -> front.send(message.toString()));
            });
        }
    }

    /** Once a second. */
    private void lookAfter(Front front) {
        Optional<Person> person = front.person();
        if (person.isPresent()) {
            Optional<Person> present = people.present(person.get());
            present.ifPresentOrElse(now -> listed(front, person.get(), now), () -> FrontLogins.bye(front));
        } else if (front.silentMillis() > HELLO_MS) {
            front.end(StatusCode.POLICY_VIOLATION, "no hello");
        }
        if (front.silentMillis() > SILENT_MS) {
            front.cut();
        } else if (ticks % (PING_MS / TICK_MS) == 0) {
            front.ping();
        }
    }

    @Override
    public void close() {
        execute(() -> List.copyOf(open).forEach(front -> front.end(StatusCode.SHUTDOWN, "the session ends")));
        feed.close();
        rows.close();
        thread.shutdown();
        try {
            if (!thread.awaitTermination(2, TimeUnit.SECONDS)) {
                thread.shutdownNow();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
