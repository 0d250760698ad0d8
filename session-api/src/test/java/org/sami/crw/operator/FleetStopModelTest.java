package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Role;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Welcome;
import org.sami.crw.operator.boat.FleetStopState;
import org.sami.crw.operator.boat.UnreachedBoat;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.BoatProxy;
import org.sami.spn.protocol.Priority;

/** How a latched stop is told, whoever latched it. */
class FleetStopModelTest {
    private static final LinkCodec CODEC = new LinkCodec();

    private final ModelWorld world = new ModelWorld();
    private final OperatorModels models = world.models;
    private final Map<String, Long> sequences = new HashMap<>();
    private final BoatProxy anna = linked("anna");
    private final BoatProxy bert = linked("bert");

    private void says(BoatProxy boat, LinkMessage message) {
        long sequence = sequences.merge(boat.boatId(), 1L, Long::sum);
        boat.receive(CODEC.encode(sequence, message), world.nowMillis.get());
    }

    private BoatProxy linked(String id) {
        BoatProxy boat = world.boat(id);
        says(boat, new Welcome(id, id + "-boot", Role.COMMANDER, ""));
        return boat;
    }

    private void does(BoatProxy boat, BoatMode mode) {
        world.nowMillis.addAndGet(1000);
        says(boat, new Telemetry(45, 10, 0, 0, 80, mode, world.nowMillis.get()));
        world.nowMillis.addAndGet(1000);
        models.look();
        world.settle();
    }

    private FleetStopState state() {
        world.settle();
        return models.fleetStop().snapshot();
    }

    private List<HealthEntry> faults() {
        return models.health().snapshot().of(HealthKind.FLEET_STOP);
    }

    @Test
    void stopOfTheWholeFleetSaysWhoHasNotConfirmedItAndIsOverWithTheRelease() {
        does(anna, BoatMode.STOPPED);
        does(bert, BoatMode.STOPPED);
        assertThat(state()).isEqualTo(FleetStopState.NONE);

        models.fleetStop().commanded(true);
        anna.fleetStop();
        bert.fleetStop();
        does(anna, BoatMode.FLEET_STOP);

        assertThat(state().words())
                .isEqualTo(
                        "FLEET STOP: 1 of 2 boats is stopped; nothing moves before the release; bert has not said so");
        assertThat(state().stops("bert")).isTrue();
        does(bert, BoatMode.FLEET_STOP);
        models.unreached().show(List.of(new UnreachedBoat("10.0.0.9:11411", "", "connection refused", false, 3, 0)));
        assertThat(state().words())
                .isEqualTo("FLEET STOP: 2 of 3 boats are stopped; nothing moves before the release; 10.0.0.9:11411 has"
                        + " not said so");
        models.unreached().show(List.of());
        assertThat(state().words()).isEqualTo("FLEET STOP: 2 of 2 boats are stopped; nothing moves before the release");
        assertThat(faults()).singleElement().satisfies(entry -> {
            assertThat(entry.severity()).isEqualTo(Priority.CRITICAL);
            assertThat(entry.fault().text()).isEqualTo(state().words());
        });

        models.fleetStop().commanded(false);
        does(anna, BoatMode.STOPPED);
        assertThat(faults()).hasSize(1);
        anna.fleetRelease();
        bert.fleetRelease();
        does(bert, BoatMode.STOPPED);
        does(anna, BoatMode.STOPPED);
        assertThat(state()).isEqualTo(FleetStopState.NONE);
        assertThat(faults()).isEmpty();
    }

    @Test
    void baseThatLatchedAStopIsNamedWhereTheBoatSaysIt() {
        Gains gains = new Gains(1, 0, 0);
        says(
                anna,
                new SettingsReport(
                        gains, gains, 1, LostLinkAction.HOLD, Optional.empty(), Optional.empty(), "committee-boat"));
        does(anna, BoatMode.FLEET_STOP);
        does(bert, BoatMode.STOPPED);

        assertThat(state().words()).isEqualTo("Stopped by committee-boat: anna; it does not move before the release");
        assertThat(state().advice()).startsWith("Ask committee-boat, then release it");
        assertThat(state().details())
                .isEqualTo("committee-boat stopped it, another base, or this one before it started anew");
        assertThat(models.fleet().boat("anna").orElseThrow().why().text())
                .startsWith("anna does not move: it is stopped by committee-boat until it is released");

        does(bert, BoatMode.FLEET_STOP);
        assertThat(state().words())
                .isEqualTo("FLEET STOP, not from here: 2 of 2 boats are stopped; nothing moves before the release");
    }

    @Test
    void stopThatAnotherBaseLatchedIsToldAsSuch() {
        does(anna, BoatMode.FLEET_STOP);
        does(bert, BoatMode.FLEET_STOP);

        assertThat(state().isOfFleet()).isTrue();
        assertThat(state().words())
                .isEqualTo("FLEET STOP, not from here: 2 of 2 boats are stopped; nothing moves before the release");
        assertThat(state().advice()).startsWith("Ask the other base, then release it");
        assertThat(faults().get(0).fault().details())
                .isEqualTo("Another base stopped it, or this one before it started anew");
        assertThat(faults()).hasSize(1);
        assertThat(models.fleet().boat("anna").orElseThrow().why().text())
                .startsWith("anna does not move: it is stopped, not from here, until it is released");
    }

    private void isTaken(BoatProxy boat, double speedMps) {
        says(
                boat,
                new Welcome(
                        boat.boatId(),
                        boat.boatId() + "-boot",
                        Role.OBSERVER,
                        "",
                        "",
                        true,
                        Optional.of(new CommandEpoch(2, "", "a pilot (MANUAL)"))));
        world.nowMillis.addAndGet(1000);
        says(boat, new Telemetry(45, 10, 0, speedMps, 80, BoatMode.TELEOPERATION, world.nowMillis.get()));
        world.nowMillis.addAndGet(1000);
        models.look();
        world.settle();
    }

    private SettingsReport stoppedBy(String client) {
        Gains gains = new Gains(1, 0, 0);
        return new SettingsReport(gains, gains, 1, LostLinkAction.HOLD, Optional.empty(), Optional.empty(), client);
    }

    @Test
    void whoArmsAStoppedVehicleIsNamedFirstAndNothingIsSaidNotToMoveThatDoes() {
        models.fleetStop().commanded(true);
        for (BoatProxy boat : List.of(anna, bert)) {
            boat.fleetStop();
            says(boat, stoppedBy("base"));
            does(boat, BoatMode.FLEET_STOP);
        }

        isTaken(anna, 0);
        assertThat(state().words())
                .isEqualTo("FLEET STOP: anna is armed by a pilot (MANUAL); 1 of 2 boats is stopped;"
                        + " nothing else moves before the release");

        isTaken(anna, 6.6);
        assertThat(state().words())
                .isEqualTo("FLEET STOP: anna is armed by a pilot (MANUAL), and moves; 1 of 2 boats is stopped;"
                        + " nothing else moves before the release");
        assertThat(state().words("anna")).isEqualTo("it was stopped, and is armed by a pilot (MANUAL), and moves");
        assertThat(state().advice()).startsWith("Stop it again (F12");
        assertThat(models.fleet().boat("anna").orElseThrow().why().text())
                .isEqualTo("anna moves at 6.6 m/s: a pilot (MANUAL) commands the boat");
        assertThat(faults())
                .singleElement()
                .satisfies(entry -> assertThat(entry.severity()).isEqualTo(Priority.CRITICAL));

        does(anna, BoatMode.FLEET_STOP);
        assertThat(state().words()).isEqualTo("FLEET STOP: 2 of 2 boats are stopped; nothing moves before the release");
    }

    @Test
    void vehicleThatAloneWasStoppedAndIsArmedByOthersIsTold() {
        does(bert, BoatMode.STOPPED);
        anna.fleetStop();
        says(anna, stoppedBy("base"));
        does(anna, BoatMode.FLEET_STOP);

        isTaken(anna, 2);

        assertThat(state().words()).isEqualTo("Stopped, but anna is armed by a pilot (MANUAL), and moves");
        assertThat(faults())
                .singleElement()
                .satisfies(entry -> assertThat(entry.severity()).isEqualTo(Priority.CRITICAL));
    }

    @Test
    void boatThatIsStoppedByItselfStopsNoFleet() {
        does(bert, BoatMode.STOPPED);
        anna.fleetStop();
        does(anna, BoatMode.FLEET_STOP);

        assertThat(state().isOfFleet()).isFalse();
        assertThat(state().words()).isEqualTo("Stopped: anna; it does not move before the release");
        assertThat(faults())
                .singleElement()
                .satisfies(entry -> assertThat(entry.severity()).isEqualTo(Priority.HIGH));
    }
}
