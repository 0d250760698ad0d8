package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Progress;
import org.sami.boat.link.Role;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.alarm.Alarm.Kind;
import org.sami.crw.operator.boat.BoatCommands;
import org.sami.crw.operator.boat.BoatCommands.Concluded;
import org.sami.crw.operator.boat.BoatCommands.End;
import org.sami.crw.operator.boat.BoatCommunication;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.crw.operator.map.ShownPath;
import org.sami.crw.operator.map.ShownWayHome;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.service.water.Water;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

class FleetModelsTest {
    private static final LinkCodec CODEC = new LinkCodec();
    private static final List<Priority> PRIORITIES = List.of(Priority.values());
    private static final GeoPoint HOME = GeoPoint.of(45, 10);

    private final ModelWorld world = new ModelWorld();
    private final OperatorModels models = world.models;
    private final Map<String, Long> sequences = new HashMap<>();

    private void says(BoatProxy boat, LinkMessage message) {
        long sequence = sequences.merge(boat.boatId(), 1L, Long::sum);
        boat.receive(CODEC.encode(sequence, message), world.nowMillis.get());
    }

    private BoatProxy linked(String id) {
        BoatProxy boat = world.boat(id);
        says(boat, new Welcome(id, id + "-boot", Role.COMMANDER, ""));
        says(boat, new Progress("", 0, false));
        return boat;
    }

    private void isAt(BoatProxy boat, double latDeg) {
        says(boat, new Telemetry(latDeg, 10, 0, 1, 80, BoatMode.STOPPED, world.nowMillis.get()));
    }

    @Test
    void boatsAreInTheOrderOfTheirNumbers() {
        linked("boat10");
        linked("boat2");
        linked("Boat1");
        models.look();
        world.settle();

        assertThat(models.fleet().snapshot())
                .extracting(BoatSnapshot::boat)
                .containsExactly("Boat1", "boat2", "boat10");
        assertThat(models.communication().snapshot())
                .extracting(BoatCommunication::boat)
                .containsExactly("Boat1", "boat2", "boat10");
    }

    @Test
    void twentyBoatsAreShownTenTimesASecondEachHoweverOftenTheySpeak() {
        List<BoatProxy> fleet = new ArrayList<>();
        for (int i = 0; i < 20; i++) {
            fleet.add(linked("boat" + i));
        }
        Map<String, Integer> shown = new HashMap<>();
        Map<String, Double> last = new HashMap<>();
        models.fleet()
                .addListener(boats -> boats.forEach(boat -> {
                    double latDeg =
                            boat.pose().map(pose -> pose.position().latDeg()).orElse(0.0);
                    if (!Double.valueOf(latDeg).equals(last.put(boat.boat(), latDeg))) {
                        shown.merge(boat.boat(), 1, Integer::sum);
                    }
                }));
        for (int tick = 0; tick < 1000; tick++) { // 10 s, at 100 Hz
            world.nowMillis.addAndGet(10);
            for (BoatProxy boat : fleet) {
                isAt(boat, 45 + tick / 100_000.0);
            }
            if (tick % 10 == 9) {
                models.look();
            }
            world.settle();
        }
        world.nowMillis.addAndGet(100);
        models.look();
        world.settle();

        assertThat(shown).hasSize(20);
        assertThat(shown.values()).allSatisfy(times -> assertThat(times).isBetween(95, 102));
        assertThat(models.fleet().snapshot()).allSatisfy(boat -> {
            assertThat(boat.pose().orElseThrow().position().latDeg()).isEqualTo(45 + 999 / 100_000.0);
            assertThat(boat.poseAgeMillis(world.nowMillis.get())).isEqualTo(OptionalLong.of(100));
            assertThat(boat.commander()).isEqualTo(Commander.THIS_BASE);
        });
    }

    @Test
    void telemetryDoesNotPileUpWhileTheOwnerIsBusy() {
        BoatProxy boat = linked("anna");
        world.settle();
        for (int i = 0; i < 10_000; i++) {
            world.nowMillis.addAndGet(100);
            isAt(boat, 45 + i / 1e6);
        }

        assertThat(world.ownerWork).hasSizeLessThanOrEqualTo(1);
        List<List<BoatSnapshot>> told = new ArrayList<>();
        models.fleet().addListener(told::add);
        world.settle();

        assertThat(told).hasSize(1);
        assertThat(models.fleet().boat("anna").orElseThrow().pose().map(BoatPose::position))
                .isEqualTo(boat.status().pose().map(BoatPose::position));
    }

    @Test
    void aSilentBoatIsNotNewAtEveryLook() {
        linked("anna");
        world.nowMillis.addAndGet(100);
        world.boats.tick(world.nowMillis.get());
        models.look();
        world.settle();
        List<List<BoatSnapshot>> told = new ArrayList<>();
        models.fleet().addListener(told::add);
        for (int i = 0; i < 20; i++) {
            world.nowMillis.addAndGet(100);
            world.boats.tick(world.nowMillis.get());
            models.look();
            world.settle();
        }

        assertThat(told).isEmpty();
        assertThat(models.fleet().boat("anna").orElseThrow().linkAgeMillis(world.nowMillis.get()))
                .isEqualTo(OptionalLong.of(2100));
    }

    /** The queue as it is told is compared with the proxy's, and what is gone with what was done to it. */
    @Test
    void commandQueuesAreFollowedThroughRandomCommands() {
        SplittableRandom random = new SplittableRandom(11);
        BoatProxy boat = world.boat("anna");
        Map<String, End> ends = new HashMap<>();
        world.events.subscribe(event -> {
            if (event instanceof FleetEvent.CommandWithdrawn displaced) {
                ends.put(displaced.command().commandId(), End.DISPLACED);
            }
        });
        for (int i = 0; i < 500; i++) {
            if (random.nextInt(3) > 0) {
                Priority priority = PRIORITIES.get(random.nextInt(4));
                FollowPath path = FollowPath.of("c" + i, 1L + random.nextInt(4), 1, List.of(HOME, HOME), priority);
                boat.commands().submit(random.nextInt(4) == 0 ? path.blocking() : path);
            } else if (random.nextBoolean()) {
                boat.commands()
                        .withdraw(1L + random.nextInt(4))
                        .forEach(gone -> ends.put(gone.commandId(), End.WITHDRAWN));
            } else {
                boat.commands().current().ifPresent(current -> {
                    boat.commands().withdraw(current.commandId());
                    ends.put(current.commandId(), End.WITHDRAWN);
                });
            }
            world.settle();
            BoatCommands shown = models.commands().snapshot().get(0);
            assertThat(shown.queue()).isEqualTo(boat.commands().queue());
            assertThat(shown.concluded())
                    .allSatisfy(gone -> assertThat(gone.end())
                            .as(gone.command().commandId())
                            .isEqualTo(ends.get(gone.command().commandId())));
        }
        assertThat(ends).hasSizeGreaterThan(100).containsValue(End.DISPLACED);
        assertThat(models.commands().snapshot().get(0).concluded())
                .hasSize(20)
                .extracting(Concluded::why)
                .doesNotContain("");
    }

    @Test
    void theMapShowsTheWayAroundWhatABoatIsToAvoid() {
        BoatProxy boat = linked("anna");
        isAt(boat, HOME.latDeg());
        GeoArea rock = new GeoArea(
                List.of(
                        GeoPoint.of(45.0010, 9.9995),
                        GeoPoint.of(45.0010, 10.0004),
                        GeoPoint.of(45.0014, 10.0004),
                        GeoPoint.of(45.0014, 9.9995)),
                List.of());
        Water water = Water.of(HOME, List.of(rock), Optional.empty());
        GeoPoint behindTheRock = GeoPoint.of(45.0024, 10);
        boat.commands()
                .submit(FollowPath.goTo("c", 1, 1, behindTheRock, Priority.MEDIUM)
                        .in(water));
        world.settle();

        ShownPath shown = models.map().snapshot().paths().get(0);

        List<GeoPoint> driven = new ArrayList<>(List.of(HOME));
        driven.addAll(shown.ahead());
        assertThat(driven).hasSizeGreaterThan(2).endsWith(behindTheRock);
        assertThat(water.allows(driven)).isTrue();
    }

    @Test
    void theMapShowsTheWayHomeOfABoatThatIsSetToReturnFromTheLossOfItsLinkUntilItDoesSomethingElse() {
        BoatProxy boat = linked("anna");
        says(boat, settings(LostLinkAction.RETURN));
        isAt(boat, 45.001);
        boat.closed(world.nowMillis.get());
        assertThat(waysHome()).containsExactly(new ShownWayHome("anna", List.of(GeoPoint.of(45.001, 10), HOME)));

        says(boat, new Welcome("anna", "anna-boot", Role.COMMANDER, ""));
        says(boat, new Telemetry(45.0005, 10, 0, 1, 80, BoatMode.RETURN, world.nowMillis.get()));
        assertThat(waysHome()).hasSize(1);

        says(boat, new Telemetry(45.0005, 10, 0, 1, 80, BoatMode.PATH, world.nowMillis.get()));
        assertThat(waysHome()).isEmpty();
    }

    @Test
    void aBoatThatHoldsItsPlaceWithoutALinkHasNoWayHomeOnTheMap() {
        BoatProxy boat = linked("anna");
        says(boat, settings(LostLinkAction.HOLD));
        isAt(boat, 45.001);
        boat.closed(world.nowMillis.get());

        assertThat(waysHome()).isEmpty();
    }

    private static SettingsReport settings(LostLinkAction action) {
        Gains gains = new Gains(1, 0, 0);
        Waypoint home = new Waypoint(HOME.latDeg(), HOME.lonDeg(), 1);
        return new SettingsReport(gains, gains, 1, action, Optional.of(home), Optional.empty());
    }

    private List<ShownWayHome> waysHome() {
        world.nowMillis.addAndGet(200);
        models.look();
        world.settle();
        return models.map().snapshot().waysHome();
    }

    @Test
    void aBoatInOtherHandsIsShownAsSuch() {
        BoatProxy boat = linked("anna");
        boat.teleoperate(0.5, 0);
        world.nowMillis.addAndGet(1000);
        models.look();
        world.settle();
        assertThat(models.commands().snapshot().get(0).inOtherHands()).isEqualTo("a person drives it by hand");
        assertThat(models.fleet().boat("anna").orElseThrow().commander()).isEqualTo(Commander.BY_HAND);

        boat.release();
        says(boat, new Welcome("anna", "anna-boot", Role.OBSERVER, ""));
        world.settle();

        assertThat(models.commands().snapshot().get(0).inOtherHands()).isEqualTo("another client commands it");
    }

    @Test
    void anAlarmStaysUntilItIsOverAndAcknowledged() {
        see(snapshot(LinkState.LOST, BatteryLevel.NOMINAL, Cause.LINK_LOST, HOME));
        assertThat(alarm(Kind.LINK_LOST)).hasValueSatisfying(alarm -> {
            assertThat(alarm.sounds()).isTrue();
            assertThat(alarm.text()).contains("anna");
        });

        see(snapshot(LinkState.LINKED, BatteryLevel.NOMINAL, Cause.NO_COMMAND, HOME));
        assertThat(alarm(Kind.LINK_LOST)).map(Alarm::active).contains(false);

        models.alarms().acknowledge(Kind.LINK_LOST, "anna");
        world.settle();
        assertThat(models.alarms().snapshot()).isEmpty();
    }

    @Test
    void anAcknowledgedAlarmIsSilentUntilItComesAgain() {
        see(snapshot(LinkState.LOST, BatteryLevel.NOMINAL, Cause.LINK_LOST, HOME));
        models.alarms().acknowledge(Kind.LINK_LOST, "anna");
        world.settle();
        assertThat(alarm(Kind.LINK_LOST)).map(Alarm::sounds).contains(false);

        see(snapshot(LinkState.LINKED, BatteryLevel.NOMINAL, Cause.NO_COMMAND, HOME));
        assertThat(alarm(Kind.LINK_LOST)).isEmpty();
        see(snapshot(LinkState.LOST, BatteryLevel.NOMINAL, Cause.LINK_LOST, HOME));

        assertThat(alarm(Kind.LINK_LOST)).map(Alarm::sounds).contains(true);
        models.alarms().mute(Kind.LINK_LOST, "anna", true);
        world.settle();
        assertThat(alarm(Kind.LINK_LOST)).map(Alarm::sounds).contains(false);
    }

    @Test
    void theWorstAlarmComesFirst() {
        world.step(OperatingArea.remember(
                new GeoArea(List.of(GeoPoint.of(45, 9.9), GeoPoint.of(45.1, 10), GeoPoint.of(45, 10.1)), List.of())));
        see(snapshot(LinkState.LOST, BatteryLevel.NOMINAL, Cause.LINK_LOST, GeoPoint.of(45.01, 10)));
        world.nowMillis.set(1000);
        see(snapshot(LinkState.LOST, BatteryLevel.CRITICAL, Cause.LINK_LOST, GeoPoint.of(44.99, 10)));
        assertThat(models.alarms().snapshot())
                .extracting(Alarm::kind)
                .containsExactly(Kind.BATTERY_CRITICAL, Kind.FENCE, Kind.LINK_LOST);

        see(snapshot(LinkState.LINKED, BatteryLevel.NOMINAL, Cause.NO_PROGRESS, GeoPoint.of(45.01, 10)));
        assertThat(models.alarms().snapshot())
                .filteredOn(Alarm::active)
                .extracting(Alarm::kind)
                .containsExactly(Kind.NO_PROGRESS);
    }

    private Optional<Alarm> alarm(Kind kind) {
        return models.alarms().snapshot().stream()
                .filter(alarm -> alarm.kind() == kind)
                .findFirst();
    }

    private void see(BoatSnapshot boat) {
        models.fleet().seen("anna", Optional.of(boat));
        world.settle();
    }

    private static BoatSnapshot snapshot(LinkState link, BatteryLevel battery, Cause cause, GeoPoint at) {
        return new BoatSnapshot(
                "anna",
                link,
                OptionalLong.empty(),
                Optional.of(new BoatPose(at, 0, 0, 0)),
                0,
                Optional.of(new BatteryState(50, battery)),
                Optional.empty(),
                Commander.THIS_BASE,
                Optional.empty(),
                0,
                0,
                new BoatExplanation(false, cause, "anna does not move"),
                List.of());
    }
}
