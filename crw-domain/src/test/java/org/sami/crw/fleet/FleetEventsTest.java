package org.sami.crw.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.fleet.publishing.FleetEvents;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.spn.host.Registration;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

class FleetEventsTest {
    private static final List<GeoPoint> POINTS = List.of(GeoPoint.of(45, 10), GeoPoint.of(45.001, 10));

    private final FleetEvents events = new FleetEvents();
    private final List<FleetEvent> heard = new ArrayList<>();
    private final BoatProxy boat = new BoatProxy("anna", frame -> {}, events::publish, ProxyConfig.DEFAULT);

    @Test
    void whoHasUnsubscribedHearsNothingMore() {
        Registration registration = events.subscribe(heard::add);
        boat.commands().submit(path("c1", 1));
        int before = heard.size();

        registration.close();
        boat.commands().submit(path("c2", 2));

        assertThat(before).isPositive();
        assertThat(heard).hasSize(before);
    }

    @Test
    void subscribersHearBeforeTheDomain() {
        List<String> order = new ArrayList<>();
        events.subscribe(event -> order.add("subscriber"));
        events.passTo(event -> order.add("domain"));
        events.subscribe(event -> order.add("late subscriber"));

        events.publish(new FleetEvent.TakenOver("anna"));

        assertThat(order).containsExactly("subscriber", "late subscriber", "domain");
    }

    @Test
    void whatAListenerThrowsIsPublishedAndTheNextHearsTheEvent() {
        events.subscribe(event -> {
            throw new IllegalStateException("spilled");
        });
        events.subscribe(heard::add);

        events.publish(new FleetEvent.TakenOver("anna"));

        assertThat(heard).hasSize(2);
        assertThat(heard.get(0)).isEqualTo(new FleetEvent.TakenOver("anna"));
        assertThat(heard.get(1))
                .isInstanceOfSatisfying(
                        FleetEvent.ListenerFault.class,
                        fault -> assertThat(fault.cause()).hasMessage("spilled"));
    }

    @Test
    void whatAListenerOfTheDomainThrowsIsPublishedToTheNextAndToSubscribers() {
        List<FleetEvent> domain = new ArrayList<>();
        events.subscribe(heard::add);
        events.passTo(event -> {
            throw new AssertionError("spilled");
        });
        events.passTo(domain::add);

        events.publish(new FleetEvent.TakenOver("anna"));

        assertThat(domain).isEqualTo(heard).hasSize(2);
        assertThat(domain.get(0)).isEqualTo(new FleetEvent.TakenOver("anna"));
        assertThat(domain.get(1)).isInstanceOf(FleetEvent.ListenerFault.class);
    }

    @Test
    @Timeout(900)
    void aSubscriberThatBlocksForEverHoldsUpNobody() throws Exception {
        CountDownLatch never = new CountDownLatch(1);
        ExecutorService own = Executors.newSingleThreadExecutor();
        try {
            events.subscribe(own, event -> awaitQuietly(never));
            events.subscribe(heard::add);
            for (int mission = 1; mission <= 1000; mission++) {
                boat.commands().submit(path("c" + mission, mission));
            }

            assertThat(heard)
                    .filteredOn(FleetEvent.QueueChanged.class::isInstance)
                    .hasSize(1000);
        } finally {
            own.shutdownNow();
            assertThat(own.awaitTermination(60, TimeUnit.SECONDS)).isTrue();
        }
        boat.commands().submit(path("after", 2000)); // whose executor has ended is told nothing
    }

    @Test
    void aQueueIsToldWithWhoHasItsTurnAndWhyTheOthersWait() {
        events.subscribe(heard::add);
        boat.commands().submit(path("c1", 1).blocking());
        boat.commands().submit(path("c2", 2));

        CommandQueueSnapshot queue = lastQueue();
        assertThat(queue.current()).map(entry -> entry.command().commandId()).contains("c1");
        assertThat(queue.current()).map(CommandQueueSnapshot.Entry::points).contains(2);
        assertThat(queue.blockedBy()).isEqualTo(OptionalLong.of(1));
        assertThat(queue.waiting()).singleElement().satisfies(waiting -> {
            assertThat(waiting.command().commandId()).isEqualTo("c2");
            assertThat(waiting.why().words(MissionTitles.NONE)).isEqualTo("mission 1 keeps the boat");
            assertThat(waiting.why().words(mission -> Optional.of("Survey")))
                    .isEqualTo("mission 1, Survey keeps the boat");
        });

        boat.commands().withdraw(1);

        assertThat(lastQueue().current())
                .map(entry -> entry.command().commandId())
                .contains("c2");
        assertThat(lastQueue().blockedBy()).isEmpty();
        assertThat(lastQueue()).isEqualTo(boat.commands().queue());
    }

    private CommandQueueSnapshot lastQueue() {
        return heard.stream()
                .filter(FleetEvent.QueueChanged.class::isInstance)
                .map(event -> ((FleetEvent.QueueChanged) event).queue())
                .reduce((first, second) -> second)
                .orElseThrow();
    }

    private static FollowPath path(String id, long mission) {
        return FollowPath.of(id, mission, 1, POINTS, Priority.MEDIUM);
    }

    private static void awaitQuietly(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
