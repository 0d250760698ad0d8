package org.sami.crw.mavlink;

import java.util.Arrays;
import java.util.stream.Stream;

/**
 * One case of the matrix of faults: what fails, and in which phase of a path.
 *
 * @param fault what fails
 * @param phase when
 */
record FaultCase(Fault fault, Phase phase) {
    /** What fails: the link, the vehicle's process, its power, or the base. */
    enum Fault {
        LINK_CUT,
        VEHICLE_STANDS_STILL,
        REBOOT,
        BASE_KILLED
    }

    /** How far a base is with a vehicle and its path. */
    enum Phase {
        BEFORE_CONNECTING,
        CONNECTING,
        UPLOAD_BEGUN,
        UPLOAD_HALF,
        UPLOADED,
        STARTING,
        UNDER_WAY,
        HALF_WAY,
        BY_HAND,
        STOPPED;

        boolean isConnected() {
            return this != BEFORE_CONNECTING && this != CONNECTING;
        }

        boolean moves() {
            return this == UNDER_WAY || this == HALF_WAY || this == BY_HAND;
        }

        /** Whether a path was ordered before the fault. */
        boolean isOrdered() {
            return isConnected() && this != BY_HAND;
        }

        /** Whether the vehicle has set off along its path before the fault. */
        boolean hasSetOff() {
            return this == UNDER_WAY || this == HALF_WAY || this == STOPPED;
        }
    }

    /** Each fault in each phase. */
    static Stream<FaultCase> all() {
        return Arrays.stream(Fault.values())
                .flatMap(fault -> Arrays.stream(Phase.values()).map(phase -> new FaultCase(fault, phase)));
    }

    /** Whether there is somebody to whom the fault could be told. */
    boolean isTold() {
        return phase.isConnected() && fault != Fault.BASE_KILLED;
    }

    /** Whether the vehicle lies disarmed after the fault, though it had set off before. */
    boolean isArmedAgain() {
        return fault == Fault.REBOOT || phase == Phase.STOPPED;
    }

    @Override
    public String toString() {
        return fault + " while " + phase;
    }
}
