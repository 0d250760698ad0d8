package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.handler.planning.ServiceThreads;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.Interruption;
import org.sami.crw.service.coverage.Coverage;
import org.sami.crw.service.coverage.CoverageProblem;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;

/** What services compute in a session in real time: boats live on meanwhile, and nobody computes for what is over. */
@Tag("long")
@Timeout(900)
class ComputationsTest {
    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final CountDownLatch begun = new CountDownLatch(1);
    private final CountDownLatch ended = new CountDownLatch(1);
    private ServiceThreads threads;
    private TestWorld world;

    private void world(CrwServices services, long limitMillis) {
        threads = new ServiceThreads(limitMillis);
        world = new TestWorld(engine, services, threads);
        world.addBoat("west", -60, 0);
        world.addBoat("east", 60, 0);
        world.run(1);
    }

    @AfterEach
    void endThreads() {
        threads.close();
    }

    /** Services of which that for areas is never done by itself. */
    private CrwServices withoutEnd() {
        CrwServices standard = CrwServices.STANDARD;
        return new CrwServices(standard.allocation(), standard.paths(), standard.assembly(), this::neverDone);
    }

    private Coverage neverDone(CoverageProblem problem) {
        begun.countDown();
        try {
            while (true) {
                Interruption.check();
                Thread.onSpinWait();
            }
        } finally {
            ended.countDown();
        }
    }

    private Activation asks(TestActivations asking) {
        Activation activation = asking.of("west", "east").activation();
        engine.open.add(activation);
        engine.missions.put(
                1L,
                new MissionView(
                        1, 0, 1, "plan", "", MissionStatus.RUNNING, Map.of(activation.place(), activation.tokens())));
        world.happens(engine, new Effect.Activated(activation));
        return activation;
    }

    private Activation exploring() {
        GeoArea area = new GeoArea(List.of(at(-20, -20), at(20, -20), at(20, 20), at(-20, 20)), List.of());
        return asks(new TestActivations("ProxyExploreArea").with("area", area).with("spacing", new RealValue(5)));
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TestWorld.HOME, eastM, northM);
    }

    private List<String> messages() {
        return world.operator.messages().messages().stream()
                .map(OperatorMessage::text)
                .toList();
    }

    private boolean isCommanded(String boat) {
        return world.boats.find(boat).orElseThrow().commands().current().isPresent();
    }

    @Test
    void boatsLiveOnWhileAServiceComputes() {
        CountDownLatch release = new CountDownLatch(1);
        world(coveringAfter(release), ServiceThreads.STANDARD_LIMIT_MILLIS);
        exploring();

        for (int tick = 0; tick < 100; tick++) {
            world.run(0.1);
            world.boats.all().forEach(boat -> assertThat(boat.status().link()).isEqualTo(LinkState.LINKED));
        }
        assertThat(isCommanded("east")).isFalse();
        release.countDown();

        while (!isCommanded("east")) {
            world.run(0.1);
        }
    }

    @Test
    void operatorIsToldThatTheAuctionOfThousandsOfLocationsEndedAtItsLimit() {
        world(CrwServices.STANDARD, 10 * ServiceThreads.STANDARD_LIMIT_MILLIS);
        Random random = new Random(3);
        List<Value> locations = new ArrayList<>();
        for (int i = 0; i < 6000; i++) {
            locations.add(at(random.nextDouble() * 2000 - 1000, random.nextDouble() * 2000 - 1000));
        }

        asks(new TestActivations("AllocationRequest").with("locations", new ListValue(locations)));

        while (engine.received("AllocationResponse").isEmpty()) {
            world.run(0.1);
        }
        assertThat(messages())
                .anySatisfy(
                        text -> assertThat(text).contains("the auction ended at its limit after", "of 6000 locations"));
    }

    @Test
    void computationEndsWithTheActivationThatAskedForIt() throws Exception {
        world(withoutEnd(), ServiceThreads.STANDARD_LIMIT_MILLIS);
        Activation activation = exploring();
        assertThat(begun.await(60, TimeUnit.SECONDS)).isTrue();

        assertThat(world.domain.isComputing()).isTrue();
        engine.open.clear();
        world.happens(engine, new Effect.ActivationEnded(activation.id()));
        world.run(1);
        assertThat(world.domain.isComputing()).isFalse();

        assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
        world.run(5);
        assertThat(engine.inputs).noneMatch(Input.HandlerFailed.class::isInstance);
        assertThat(world.boats.all())
                .noneMatch(boat -> boat.commands().current().isPresent());
    }

    @Test
    void computationThatTakesTooLongIsGivenUpAndFails() throws Exception {
        world(withoutEnd(), 200);
        exploring();

        while (engine.inputs.stream().noneMatch(Input.HandlerFailed.class::isInstance)) {
            world.run(0.1);
        }

        assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
        assertThat(engine.inputs.stream()
                        .filter(Input.HandlerFailed.class::isInstance)
                        .map(input -> ((Input.HandlerFailed) input).reason()))
                .singleElement()
                .satisfies(reason -> assertThat(reason)
                        .contains("the division of the area to explore was given up after", "ask for less at a time"));
    }

    @Test
    void boatThatWasTakenBackMeanwhileGetsNoCommand() throws Exception {
        CountDownLatch release = new CountDownLatch(1);
        world(coveringAfter(release), ServiceThreads.STANDARD_LIMIT_MILLIS);
        Activation activation = exploring();
        assertThat(begun.await(60, TimeUnit.SECONDS)).isTrue();
        world.happens(engine, new Effect.CommandsWithdrawn(activation.mission(), List.of("west")));
        release.countDown();

        while (!isCommanded("east")) {
            world.run(0.1);
        }

        world.run(5);
        assertThat(isCommanded("west")).isFalse();
    }

    /** Services of which that for areas begins when it is let. */
    private CrwServices coveringAfter(CountDownLatch release) {
        CrwServices standard = CrwServices.STANDARD;
        return new CrwServices(standard.allocation(), standard.paths(), standard.assembly(), problem -> {
            begun.countDown();
            waitFor(release);
            return standard.coverage().cover(problem);
        });
    }

    private static void waitFor(CountDownLatch release) {
        try {
            release.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void abortByAnotherMissionFailsWhatIsStillComputedForItsBoat() {
        CountDownLatch release = new CountDownLatch(1);
        world(coveringAfter(release), ServiceThreads.STANDARD_LIMIT_MILLIS);
        exploring();

        world.happens(
                engine,
                new TestActivations("SendProxyAbortAllMissions")
                        .id(9)
                        .mission(2)
                        .of("east")
                        .effect());
        release.countDown();
        while (!isCommanded("west")) {
            world.run(0.1);
        }

        assertThat(isCommanded("east")).isFalse();
        assertThat(engine.received("ProxyPathFailed"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("east"));
    }
}
