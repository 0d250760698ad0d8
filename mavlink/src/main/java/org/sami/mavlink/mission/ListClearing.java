package org.sami.mavlink.mission;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionClearAll;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.mavlink.vehicle.VehicleId;

/** Empties a list that a vehicle holds. One that is not ready is asked again. */
final class ListClearing extends AbstractListTransfer {
    private static final long ANSWER_MS = 1_500;
    private static final int TRIES = 8;

    private final VehicleId vehicle;
    private final HeldKind kind;
    private final Consumer<Object> send;
    private int tries;
    private long sentMs;
    private Optional<IllegalStateException> notReady = Optional.empty();

    ListClearing(VehicleId vehicle, HeldKind kind, Consumer<Object> send) {
        this.vehicle = vehicle;
        this.kind = kind;
        this.send = send;
    }

    @Override
    public void begin(long nowMs) {
        tries++;
        sentMs = nowMs;
        send.accept(MissionClearAll.builder()
                .targetSystem(vehicle.system())
                .targetComponent(vehicle.component())
                .missionType(kind.type())
                .build());
    }

    @Override
    public void tick(long nowMs) {
        if (isOver() || nowMs < sentMs + ANSWER_MS) {
            return;
        }
        if (tries == TRIES) {
            fail(notReady.orElseGet(() -> new IllegalStateException(
                    "vehicle " + vehicle + " does not answer when its " + kind.words() + " is to be emptied")));
        } else {
            begin(nowMs);
        }
    }

    @Override
    public void take(Object message, long nowMs) {
        if (isOver()
                || !(message instanceof MissionAck ack)
                || ack.missionType().entry() != kind.type()) {
            return;
        }
        if (ack.type().entry() == MavMissionResult.MAV_MISSION_ACCEPTED) {
            succeed();
            return;
        }
        ListRefusedException refusal = new ListRefusedException(
                "vehicle " + vehicle + " does not empty its " + kind.words() + ": ", ack.type());
        if (mayBeReadySoon(ack.type().entry())) {
            notReady = Optional.of(refusal);
        } else {
            fail(refusal);
        }
    }

    /** Such an answer may also be a late one to a transfer before. */
    private static boolean mayBeReadySoon(@Nullable MavMissionResult result) {
        return result == MavMissionResult.MAV_MISSION_ERROR
                || result == MavMissionResult.MAV_MISSION_INVALID_SEQUENCE
                || result == MavMissionResult.MAV_MISSION_OPERATION_CANCELLED;
    }
}
