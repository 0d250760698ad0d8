package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.hull.SensorKind;
import org.sami.crw.sim.hull.SensorSetting;
import org.sami.session.record.SessionNote;

/** One boat that says too much, next to one that says what boats say, in a real session over TCP with its journal. */
@Tag("long")
@Timeout(900)
class FloodingBoatTest {
    private static final long MESSAGES = 150_000;
    private static final long MOST_JOURNAL_BYTES = 8L << 20;

    @TempDir
    private Path folder;

    private TestSession world;
    private Session session;
    private BoatOnTcp anna;

    @BeforeEach
    void openSession() throws Exception {
        world = new TestSession(folder);
        anna = world.boat("anna");
        session = world.opened(
                TestSession.project(TestSession.connecting(TestSession.address(anna))),
                folder.resolve("session.journal"));
        session.begin();
        TestSession.get(session.fleet().connect(TestSession.address(anna)));
    }

    @AfterEach
    void close() throws Exception {
        world.close();
    }

    private long journalBytes() {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.getFileName().toString().startsWith("session.journal"))
                    .mapToLong(FloodingBoatTest::size)
                    .sum();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static long size(Path file) {
        try {
            return Files.size(file);
        } catch (IOException gone) {
            return 0;
        }
    }

    private Optional<Alarm> alarm(String boat) {
        return session.models().alarms().snapshot().stream()
                .filter(one -> one.kind() == Alarm.Kind.LINK_FLOOD && one.boat().equals(boat))
                .findFirst();
    }

    private static long counted(String text) {
        Matcher numbers = Pattern.compile("(\\d+) (readings|battery|wishes|messages|welcomes|reports)")
                .matcher(text);
        long sum = 0;
        while (numbers.find()) {
            sum += Long.parseLong(numbers.group(1));
        }
        return sum;
    }

    @Test
    void boatThatFloodsIsAlarmedAndCountedWhileTheOtherIsServedAndTheJournalStaysSmall() throws Exception {
        AtomicLong taken = new AtomicLong();
        AtomicLong seen = new AtomicLong();
        session.subscribe(Runnable::run, event -> {
            seen.addAndGet(
                    event instanceof FleetEvent.StatusReported && event.boat().equals("anna") ? 1 : 0);
            boolean floods = event instanceof FleetEvent.Measured
                    || event instanceof FleetEvent.BatteryReported
                    || event instanceof FleetEvent.CommandAsked;
            taken.addAndGet(floods && event.boat().equals("mad") ? 1 : 0);
        });
        List<String> notes = new CopyOnWriteArrayList<>();
        session.addListener(new SessionListener() {
            @Override
            public void onNote(SessionNote note) {
                notes.add(note.text());
            }
        });
        long emptyBytes = journalBytes();
        try (FloodingPeer mad = new FloodingPeer("mad", MESSAGES)) {
            TestSession.get(session.fleet().connect(mad.address()));
            Await.until("it is alarmed", () -> alarm("mad").isPresent());

            List<Long> answeredMs = new ArrayList<>();
            while (mad.sent.get() < MESSAGES) {
                long asked = ProcessClock.ms();
                TestSession.get(session.fleet().setVelocityMultiplier("anna", 1));
                answeredMs.add(ProcessClock.ms() - asked);
                long before = seen.get();
                Await.until("the other boat says where it is", () -> seen.get() > before);
                assertThat(session.models().fleet().snapshot().stream()
                                .filter(boat -> boat.boat().equals("anna"))
                                .findFirst()
                                .orElseThrow()
                                .link())
                        .isEqualTo(LinkState.LINKED);
            }
            Collections.sort(answeredMs);
            assertThat(answeredMs).as("commands to the other boat meanwhile").isNotEmpty();
            assertThat(answeredMs.get(answeredMs.size() / 2))
                    .as("ms until the other boat has answered, in the median of %s", answeredMs)
                    .isLessThan(2_000);

            TestSession.get(session.fleet().stopAll());
            Await.until("the flooding boat is told to stop", () -> mad.commands.contains("fleet-stop"));
            Await.until("it is over", () -> !alarm("mad").orElseThrow().active());
            assertThat(alarm("mad").orElseThrow().text()).startsWith("mad no longer sends more");
            assertThat(journalBytes() - emptyBytes)
                    .as("bytes that the journal has grown")
                    .isLessThan(MOST_JOURNAL_BYTES);
            assertThat(counted(alarm("mad").orElseThrow().text()) + taken.get())
                    .as("what was taken and what the alarm counts: "
                            + alarm("mad").orElseThrow().text())
                    .isEqualTo(MESSAGES);
        }
        assertThat(alarm("anna")).isEmpty();
        assertThat(notes).anyMatch(note -> note.contains("ALARM: mad sends more than this base takes"));
        assertThat(notes).anyMatch(note -> note.contains("mad no longer sends more"));
    }

    @Test
    void boatWithSeveralSensorsAtTenHertzIsNotLimited() throws Exception {
        BoatOnTcp busy = world.boat(
                "busy",
                Stream.of(SensorKind.values())
                        .map(kind -> new SensorSetting(kind, SensorSetting.MOST_HZ))
                        .toArray(SensorSetting[]::new));
        AtomicLong taken = new AtomicLong();
        session.subscribe(Runnable::run, event -> {
            taken.addAndGet(event instanceof FleetEvent.Measured && event.boat().equals("busy") ? 1 : 0);
        });
        TestSession.get(session.fleet().connect(TestSession.address(busy)));

        Await.until("it has measured a lot", () -> taken.get() >= 200);
        assertThat(alarm("busy")).isEmpty();
    }
}
