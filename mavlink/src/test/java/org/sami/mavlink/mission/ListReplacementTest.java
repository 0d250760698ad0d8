package org.sami.mavlink.mission;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionClearAll;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import io.dronefleet.mavlink.common.MissionWritePartialList;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.mavlink.onboard.ListKeeper;
import org.sami.mavlink.onboard.OnboardLists;
import org.sami.mavlink.testing.BadRadio;
import org.sami.mavlink.vehicle.VehicleId;

/** Lists that are sent and read back over radios that lose, double and reorder, on a clock of the test's own; the vehicle asks for 50 items a second. */
class ListReplacementTest {
    private static final VehicleId VEHICLE = new VehicleId(3, 1);
    private static final VehicleId STATION = new VehicleId(255, 190);
    private static final int PACE_MS = 20;
    private static final long TICK_MS = 20;

    private final List<Object> sent = new ArrayList<>();
    private final List<HeldKind> changed = new ArrayList<>();
    private BadRadio<Object> up = new BadRadio<>(1, 0, 0, 1, 0);
    private BadRadio<Numbered> down = new BadRadio<>(2, 0, 0, 1, 0);
    private int messages; // of the vehicle
    private long nowMs;
    private Optional<ListKeeper.Refusal> refusal = Optional.empty();

    private final HeldLists lists = new HeldLists(VEHICLE, message -> {
        sent.add(message);
        up.send(message, nowMs);
    });
    private OnboardLists vehicle = vehicle(650);

    /** A message of the vehicle, with its number. */
    private record Numbered(int number, Object message) {}

    private OnboardLists vehicle(int capacity) {
        ListKeeper keeper = new ListKeeper() {
            @Override
            public Optional<Refusal> whyNot(HeldKind kind, MissionItem item) {
                return refusal;
            }

            @Override
            public void changed(HeldKind kind, List<MissionItem> items) {
                changed.add(kind);
            }
        };
        return new OnboardLists(
                capacity, PACE_MS, keeper, message -> down.send(new Numbered(messages++ % 256, message), nowMs));
    }

    private static List<MissionItem> mission(int items) {
        return IntStream.range(0, items)
                .mapToObj(i -> MissionItem.waypoint(i, 45.7 + i * 1e-5, 10.72, 0, i % 7))
                .toList();
    }

    private CompletableFuture<List<MissionItem>> replace(HeldKind kind, List<MissionItem> items) {
        CompletableFuture<List<MissionItem>> result = new CompletableFuture<>();
        lists.replace(kind, List.of(items), nowMs, result);
        return result;
    }

    /** How long it took. */
    private long passUntilDone(CompletableFuture<?> result) {
        return passUntilDone(result, 300_000);
    }

    private long passUntilDone(CompletableFuture<?> result, long mostMs) {
        long began = nowMs;
        while (!result.isDone() && nowMs < began + mostMs) {
            nowMs++;
            up.arrived(nowMs).forEach(message -> vehicle.take(STATION, message, nowMs));
            vehicle.tick(nowMs);
            down.arrived(nowMs).forEach(each -> lists.take(each.message, each.number, nowMs));
            if (nowMs % TICK_MS == 0) {
                lists.tick(nowMs);
            }
        }
        return nowMs - began;
    }

    @ParameterizedTest
    @CsvSource({"0, 1.2", "0.05, 2", "0.2, 4"})
    void missionOf400ItemsIsReadBackEqualInTime(double loss, double times) {
        long ownMs = 400 * (PACE_MS + 2);
        for (int seed = 0; seed < 20; seed++) {
            up = new BadRadio<>(seed, loss, loss, 1, loss == 0 ? 0 : 8);
            down = new BadRadio<>(1_000 + seed, loss, loss, 1, loss == 0 ? 0 : 8);
            vehicle = vehicle(650);
            lists.forget();
            var result = replace(HeldKind.MISSION, mission(400));
            long took = passUntilDone(result);

            assertThat(result).isCompletedWithValueMatching(items -> items.size() == 400);
            assertThat(vehicle.held(HeldKind.MISSION)).isEqualTo(mission(400));
            assertThat(took).as("seed %d", seed).isLessThanOrEqualTo(Math.round(ownMs * times));
        }
    }

    @Test
    void radioOfASecondEachWayIsEnough() {
        up = new BadRadio<>(5, 0.1, 0.1, 400, 300);
        down = new BadRadio<>(6, 0.1, 0.1, 400, 300);
        var result = replace(HeldKind.MISSION, mission(20));
        passUntilDone(result);

        assertThat(result).isCompletedWithValue(mission(20));
    }

    @Test
    void onlyThePartThatDiffersIsSentAgain() {
        passUntilDone(replace(HeldKind.MISSION, mission(100)));
        sent.clear();
        List<MissionItem> other = new ArrayList<>(mission(100));
        other.set(40, MissionItem.waypoint(40, 45.8, 10.8, 0, 0));
        other.set(42, MissionItem.waypoint(42, 45.8, 10.9, 0, 0));
        var result = replace(HeldKind.MISSION, other);
        passUntilDone(result);

        assertThat(result).isCompletedWithValue(other);
        assertThat(sent).filteredOn(MissionWritePartialList.class::isInstance).hasSize(1);
        assertThat(sent)
                .filteredOn(MissionItemInt.class::isInstance)
                .extracting(item -> ((MissionItemInt) item).seq())
                .containsExactly(40, 41, 42);
    }

    /** The new part of a list, and then one item before it. */
    private static List<List<MissionItem>> steps() {
        List<MissionItem> first = new ArrayList<>(mission(400));
        IntStream.range(200, 300).forEach(i -> first.set(i, MissionItem.waypoint(i, 45.8 + i * 1e-5, 10.8, 0, 0)));
        List<MissionItem> second = new ArrayList<>(first);
        second.set(199, MissionItem.waypoint(199, 45.8, 10.9, 0, 0));
        return List.of(first, second);
    }

    private CompletableFuture<List<MissionItem>> replaceInSteps() {
        CompletableFuture<List<MissionItem>> result = new CompletableFuture<>();
        lists.replace(HeldKind.MISSION, steps(), nowMs, result);
        return result;
    }

    @Test
    void stepsFollowOneAnotherAndAreReadBackOnce() {
        passUntilDone(replace(HeldKind.MISSION, mission(400)));
        sent.clear();
        var result = replaceInSteps();
        passUntilDone(result);

        assertThat(result).isCompletedWithValue(steps().get(1));
        assertThat(sent).filteredOn(MissionRequestList.class::isInstance).hasSize(1);
        assertThat(sent).filteredOn(MissionWritePartialList.class::isInstance).hasSize(2);
        assertThat(sent)
                .filteredOn(MissionItemInt.class::isInstance)
                .last()
                .extracting(item -> ((MissionItemInt) item).seq())
                .isEqualTo(199);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.2})
    void vehicleHasTakenAStepBeforeTheNextOneBeginsHoweverBadTheRadioIs(double loss) {
        for (int seed = 0; seed < 8; seed++) {
            up = new BadRadio<>(seed, loss, loss, 1, 8);
            down = new BadRadio<>(1_000 + seed, loss, loss, 1, 8);
            vehicle = vehicle(650);
            lists.forget();
            passUntilDone(replace(HeldKind.MISSION, mission(400)));
            var result = replaceInSteps();
            while (!result.isDone()) {
                passUntilDone(result, 10);
                List<MissionItem> held = vehicle.held(HeldKind.MISSION);
                if (held.get(199).isSameAs(steps().get(1).get(199))) {
                    assertThat(held).as("seed %d", seed).isEqualTo(steps().get(1));
                }
            }
            assertThat(result).isCompletedWithValue(steps().get(1));
        }
    }

    @Test
    void anAnswerToOneStepThatComesTwiceIsNoAnswerToTheNextOne() {
        HeldLists held = new HeldLists(VEHICLE, sent::add);
        List<List<MissionItem>> three = IntStream.rangeClosed(1, 3)
                .mapToObj(ListReplacementTest::mission)
                .toList();
        held.replace(HeldKind.MISSION, three, nowMs, new CompletableFuture<>());
        held.take(request(0), 7, nowMs);
        held.take(accepted(), 8, nowMs);
        held.take(request(0), 9, nowMs);
        held.take(request(1), 10, nowMs);
        held.take(accepted(), 8, nowMs); // its datagram, doubled on the way

        assertThat(sent).noneMatch(message -> message instanceof MissionCount count && count.count() == 3);
        held.take(accepted(), 11, nowMs);
        assertThat(sent)
                .last()
                .isInstanceOfSatisfying(
                        MissionCount.class, count -> assertThat(count.count()).isEqualTo(3));
    }

    @Test
    void anAnswerWithTheNumberOfAMuchEarlierOneCounts() {
        HeldLists held = new HeldLists(VEHICLE, sent::add);
        held.replace(HeldKind.MISSION, List.of(mission(1), mission(2), mission(3)), nowMs, new CompletableFuture<>());
        held.take(request(0), 7, nowMs);
        held.take(accepted(), 8, nowMs);
        nowMs += 5_000;
        held.take(request(0), 6, nowMs);
        held.take(request(1), 7, nowMs);
        held.take(accepted(), 8, nowMs);

        assertThat(sent)
                .last()
                .isInstanceOfSatisfying(
                        MissionCount.class, count -> assertThat(count.count()).isEqualTo(3));
    }

    /** Three short steps: the items of each are all sent once its first one is asked for. */
    private static List<List<MissionItem>> shortSteps() {
        List<MissionItem> first = new ArrayList<>(mission(400));
        IntStream.range(200, 205).forEach(i -> first.set(i, MissionItem.waypoint(i, 45.8 + i * 1e-5, 10.8, 0, 0)));
        List<MissionItem> second = new ArrayList<>(first);
        second.set(199, MissionItem.waypoint(199, 45.8, 10.9, 0, 0));
        List<MissionItem> third = new ArrayList<>(second);
        third.set(198, MissionItem.waypoint(198, 45.8, 10.9, 0, 0));
        return List.of(first, second, third);
    }

    @Test
    void shortStepIsTakenBeforeTheNextOneBeginsOnARadioThatDoublesAndReorders() {
        List<MissionItem> last = shortSteps().get(2);
        for (int seed = 0; seed < 100; seed++) {
            up = new BadRadio<>(seed, 0.2, 0.2, 1, 8);
            down = new BadRadio<>(1_000 + seed, 0.2, 0.5, 1, 60);
            vehicle = vehicle(650);
            vehicle.put(HeldKind.MISSION, mission(400));
            lists.forget();
            CompletableFuture<List<MissionItem>> known = new CompletableFuture<>();
            lists.read(HeldKind.MISSION, nowMs, known);
            passUntilDone(known);
            CompletableFuture<List<MissionItem>> result = new CompletableFuture<>();
            lists.replace(HeldKind.MISSION, shortSteps(), nowMs, result);
            while (!result.isDone()) {
                passUntilDone(result, 5);
                List<MissionItem> held = vehicle.held(HeldKind.MISSION);
                if (held.get(198).isSameAs(last.get(198))) {
                    assertThat(held).as("seed %d", seed).isEqualTo(last);
                }
            }
            assertThat(result).isCompletedWithValue(last);
        }
    }

    @Test
    void longListIsSentBeforeItIsAskedFor() {
        vehicle = vehicle(3_000);
        var result = replace(HeldKind.MISSION, mission(2_000));
        long tookMs = passUntilDone(result);

        assertThat(result).isCompletedWithValue(mission(2_000));
        assertThat(tookMs).isLessThan(2_000 * (2 * PACE_MS + 2));
    }

    @Test
    void partIsSentBeforeItIsAskedFor() {
        passUntilDone(replace(HeldKind.MISSION, mission(400)));
        List<MissionItem> other = new ArrayList<>(mission(400));
        IntStream.range(100, 250).forEach(i -> other.set(i, MissionItem.waypoint(i, 45.8 + i * 1e-5, 10.8, 0, 0)));
        sent.clear();
        var result = replace(HeldKind.MISSION, other);
        nowMs++;
        up.arrived(nowMs).forEach(message -> vehicle.take(STATION, message, nowMs));
        vehicle.tick(nowMs);
        nowMs += 2;
        down.arrived(nowMs).forEach(each -> lists.take(each.message, each.number, nowMs));

        assertThat(sent).filteredOn(MissionItemInt.class::isInstance).hasSizeBetween(50, 149);
        passUntilDone(result);
        assertThat(result).isCompletedWithValue(other);
        assertThat(sent).filteredOn(MissionItemInt.class::isInstance).hasSize(150);
    }

    @ParameterizedTest
    @CsvSource({"0.05, 0", "0.2, 0", "0.05, 8"})
    void partComesThroughABadRadio(double loss, int laterMs) {
        for (int seed = 0; seed < 20; seed++) {
            up = new BadRadio<>(seed, loss, loss, 1, laterMs);
            down = new BadRadio<>(1_000 + seed, loss, loss, 1, laterMs);
            vehicle = vehicle(650);
            lists.forget();
            passUntilDone(replace(HeldKind.MISSION, mission(400)));
            List<MissionItem> other = new ArrayList<>(mission(400));
            IntStream.range(100, 250).forEach(i -> other.set(i, MissionItem.waypoint(i, 45.8 + i * 1e-5, 10.8, 0, 0)));
            var result = replace(HeldKind.MISSION, other);
            long took = passUntilDone(result);

            assertThat(result).isCompletedWithValue(other);
            assertThat(took).as("seed %d", seed).isLessThan(4 * 550 * (PACE_MS + 2));
        }
    }

    @Test
    void missionThatIsThereAlreadyIsOnlyReadBack() {
        passUntilDone(replace(HeldKind.MISSION, mission(30)));
        sent.clear();
        var result = replace(HeldKind.MISSION, mission(30));
        passUntilDone(result);

        assertThat(result).isCompletedWithValue(mission(30));
        assertThat(sent).noneMatch(MissionItemInt.class::isInstance);
    }

    @Test
    void partIsSentWholeWhereTheVehicleHoldsAnotherLengthThanItDid() {
        passUntilDone(replace(HeldKind.MISSION, mission(100)));
        vehicle.put(HeldKind.MISSION, mission(20)); // by another ground station
        List<MissionItem> other = new ArrayList<>(mission(100));
        other.set(90, MissionItem.waypoint(90, 45.8, 10.8, 0, 0));
        var result = replace(HeldKind.MISSION, other);
        passUntilDone(result);

        assertThat(result).isCompletedWithValue(other);
    }

    @Test
    void fenceAndRallyPointsGoUpAndComeBackAndAreEmptied() {
        List<MissionItem> fence = IntStream.range(0, 4)
                .mapToObj(
                        i -> new MissionItem(i, 5001, 0, 45.7 + (i & 1) * 0.01, 10.7 + (i >> 1) * 0.01, 0, 4, 0, 0, 0))
                .toList();
        List<MissionItem> rally = List.of(new MissionItem(0, 5100, 3, 45.7, 10.72, 0, 0, 0, 0, 0));
        var first = replace(HeldKind.FENCE, fence);
        var second = replace(HeldKind.RALLY, rally);
        passUntilDone(second);

        assertThat(first).isCompletedWithValue(fence);
        assertThat(second).isCompletedWithValue(rally);
        var emptied = replace(HeldKind.FENCE, List.of());
        passUntilDone(emptied);
        assertThat(emptied).isCompletedWithValue(List.of());
        assertThat(vehicle.held(HeldKind.FENCE)).isEmpty();
        assertThat(vehicle.held(HeldKind.RALLY)).isEqualTo(rally);
    }

    @Test
    void tooLongAMissionIsRefusedInWordsAndTheOldOneStays() {
        passUntilDone(replace(HeldKind.MISSION, mission(10)));
        var result = replace(HeldKind.MISSION, mission(701));
        passUntilDone(result);

        assertThat(result)
                .failsWithin(Duration.ZERO)
                .withThrowableThat()
                .havingCause()
                .isInstanceOfSatisfying(ListRefusedException.class, why -> {
                    assertThat(why.isOutOfSpace()).isTrue();
                    assertThat(why.result()).isEqualTo(4); // of MAV_MISSION_RESULT
                })
                .withMessageContaining("vehicle 3 refuses the mission of 701 items: it holds no more items");
        assertThat(vehicle.held(HeldKind.MISSION)).isEqualTo(mission(10));
        assertThat(sent)
                .filteredOn(message -> message instanceof MissionCount count && count.count() == 701)
                .as("it is not asked again")
                .hasSize(1);
    }

    @Test
    void listIsEmptiedOnceTheVehicleIsReady() {
        List<MavMissionResult> answers = new ArrayList<>(List.of(
                MavMissionResult.MAV_MISSION_OPERATION_CANCELLED, // of a transfer before
                MavMissionResult.MAV_MISSION_ERROR,
                MavMissionResult.MAV_MISSION_ACCEPTED));

        assertThat(emptied(answers)).isCompletedWithValue(List.of());
        assertThat(answers).isEmpty();
    }

    @Test
    void vehicleThatMayNotBeEmptiedIsAskedOnce() {
        List<MavMissionResult> answers =
                new ArrayList<>(List.of(MavMissionResult.MAV_MISSION_DENIED, MavMissionResult.MAV_MISSION_ACCEPTED));

        assertThat(emptied(answers))
                .failsWithin(Duration.ZERO)
                .withThrowableThat()
                .withMessageContaining("vehicle 3 does not empty its fence");
        assertThat(answers).hasSize(1);
    }

    /** Has a vehicle's fence emptied that gives these answers, in turn. */
    private CompletableFuture<List<MissionItem>> emptied(List<MavMissionResult> answers) {
        HeldLists held = new HeldLists(VEHICLE, sent::add);
        CompletableFuture<List<MissionItem>> result = new CompletableFuture<>();
        held.replace(HeldKind.FENCE, List.of(List.of()), nowMs, result);
        while (!result.isDone() && nowMs < 60_000) {
            nowMs += TICK_MS;
            List<Object> arrived = List.copyOf(sent);
            sent.clear();
            for (Object message : arrived) {
                if (message instanceof MissionClearAll) {
                    held.take(acknowledgement(answers.remove(0)), messages++, nowMs);
                } else if (message instanceof MissionRequestList) {
                    held.take(
                            MissionCount.builder()
                                    .missionType(HeldKind.FENCE.type())
                                    .build(),
                            messages++,
                            nowMs);
                }
            }
            held.tick(nowMs);
        }
        return result;
    }

    private static MissionAck acknowledgement(MavMissionResult result) {
        return MissionAck.builder()
                .type(result)
                .missionType(HeldKind.FENCE.type())
                .build();
    }

    @Test
    void itemThatTheVehicleCannotCarryOutLeavesTheOldMission() {
        passUntilDone(replace(HeldKind.MISSION, mission(10)));
        refusal = Optional.of(ListKeeper.Refusal.UNSUPPORTED);
        changed.clear();
        var result = replace(HeldKind.MISSION, mission(12));
        passUntilDone(result);

        assertThat(result)
                .failsWithin(Duration.ZERO)
                .withThrowableThat()
                .havingCause()
                .isInstanceOfSatisfying(
                        ListRefusedException.class,
                        why -> assertThat(why.isOutOfSpace()).isFalse())
                .withMessageContaining("cannot carry out one of the items");
        assertThat(vehicle.held(HeldKind.MISSION)).isEqualTo(mission(10));
        assertThat(changed).isEmpty();
    }

    @Test
    void vehicleThatKeepsSomethingElseIsNotTrusted() {
        lists.replace(HeldKind.MISSION, List.of(mission(3)), nowMs, new CompletableFuture<>());
        lists.close();
        BadRadio<Object> honest = up;
        HeldLists other = new HeldLists(
                VEHICLE,
                message -> honest.send(
                        message instanceof MissionItemInt item && item.seq() == 2
                                ? MissionItem.waypoint(2, 45, 10, 0, 0).message(VEHICLE, HeldKind.MISSION)
                                : message,
                        nowMs));
        CompletableFuture<List<MissionItem>> result = new CompletableFuture<>();
        other.replace(HeldKind.MISSION, List.of(mission(5)), nowMs, result);
        while (!result.isDone() && nowMs < 60_000) {
            nowMs++;
            up.arrived(nowMs).forEach(message -> vehicle.take(STATION, message, nowMs));
            vehicle.tick(nowMs);
            down.arrived(nowMs).forEach(each -> other.take(each.message, each.number, nowMs));
            other.tick(nowMs);
        }

        assertThat(result)
                .failsWithin(Duration.ZERO)
                .withThrowableThat()
                .withMessageContaining("holds another mission than it was sent: item 2");
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    void aVehicleThatAnswersEachItemWithInvalidSequenceEndsTheTransferWithThatReason(int wanted) {
        HeldLists refused = new HeldLists(VEHICLE, sent::add);
        CompletableFuture<List<MissionItem>> result = new CompletableFuture<>();
        refused.replace(HeldKind.MISSION, List.of(mission(10)), nowMs, result);
        while (!result.isDone() && nowMs < 300_000) {
            nowMs += TICK_MS;
            List<Object> arrived = List.copyOf(sent);
            sent.clear();
            for (Object message : arrived) {
                refused.take(
                        message instanceof MissionCount ? request(wanted) : invalidSequence(), messages++ % 256, nowMs);
            }
            refused.tick(nowMs);
        }

        assertThat(result)
                .failsWithin(Duration.ZERO)
                .withThrowableThat()
                .withMessageContaining("vehicle 3 could not be sent its mission")
                .withMessageContaining("MAV_MISSION_INVALID_SEQUENCE");
        assertThat(nowMs).isLessThan(90_000);
    }

    private static MissionRequestInt request(int item) {
        return MissionRequestInt.builder()
                .seq(item)
                .missionType(HeldKind.MISSION.type())
                .build();
    }

    private static MissionAck accepted() {
        return MissionAck.builder()
                .type(MavMissionResult.MAV_MISSION_ACCEPTED)
                .missionType(HeldKind.MISSION.type())
                .build();
    }

    private static MissionAck invalidSequence() {
        return MissionAck.builder()
                .type(MavMissionResult.MAV_MISSION_INVALID_SEQUENCE)
                .missionType(HeldKind.MISSION.type())
                .build();
    }

    @Test
    void vehicleThatFallsSilentIsNamedWithHowFarItCame() {
        var result = replace(HeldKind.MISSION, mission(100));
        while (sent.size() < 30) {
            nowMs++;
            up.arrived(nowMs).forEach(message -> vehicle.take(STATION, message, nowMs));
            vehicle.tick(nowMs);
            down.arrived(nowMs).forEach(each -> lists.take(each.message, each.number, nowMs));
        }
        up = new BadRadio<>(1, 1, 0, 1, 0);
        passUntilDone(result);

        assertThat(result).failsWithin(Duration.ZERO).withThrowableThat().withMessageContaining("vehicle 3");
        assertThat(vehicle.held(HeldKind.MISSION)).isEmpty();
    }
}
