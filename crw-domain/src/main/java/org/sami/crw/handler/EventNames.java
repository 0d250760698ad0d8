package org.sami.crw.handler;

import java.util.Set;
import org.sami.boat.link.BatteryLevel;

/** The input events that this package answers with, as the domain's vocabulary names them. */
public final class EventNames {
    static final String PATH_COMPLETED = "ProxyPathCompleted";
    static final String PATH_FAILED = "ProxyPathFailed";
    static final String LIST_COMPLETED = "ProxyListCompleted";
    static final String BLOCK_DONE = "BlockMovementDone";
    static final String ENTERED_AREA = "ProxyEnteredArea";
    static final String LEFT_AREA = "ProxyLeftArea";
    static final String PANORAMA_TAKEN = "PanoramaTaken";
    static final String PANORAMA_FAILED = "PanoramaFailed";
    static final String MEASUREMENT_TAKEN = "MeasurementTaken";
    static final String MEASUREMENT_FAILED = "MeasurementFailed";
    static final String GAINS_SUCCEEDED = "SetGainsSucceeded";
    static final String GAINS_FAILED = "SetGainsFailed";
    static final String MULTIPLIER_SUCCEEDED = "SetVelocityMultiplierSucceeded";
    static final String MULTIPLIER_FAILED = "SetVelocityMultiplierFailed";
    static final String ALLOCATION_RESPONSE = "AllocationResponse";
    static final String PATH_RESPONSE = "PathResponse";
    static final String DISTRIBUTE_RESPONSE = "DistributeLocationsResponse";
    static final String ASSEMBLE_RESPONSE = "AssembleLocationResponse";
    static final String QUANTITY_GREATER = "QuantityGreater";
    static final String QUANTITY_LESS = "QuantityLess";
    static final String QUANTITY_EQUAL = "QuantityEqual";
    static final String PROXY_CREATED = "ProxyCreated";
    static final String PROXY_CONNECTED = "ProxyConnected";
    /** Answer to Task Complete. */
    public static final String TASK_COMPLETED = "TaskCompleted";

    static final String POSE_UPDATED = "ProxyPoseUpdated";
    /** News of a battery. */
    public static final String BATTERY_NOMINAL = "BatteryNominal";
    /** News of a battery. */
    public static final String BATTERY_LOW = "BatteryLow";
    /** News of a battery. */
    public static final String BATTERY_CRITICAL = "BatteryCritical";

    static final String PROXY_ABORTED = "ProxyAbortMissionReceived";
    static final String TAKEN_OVER = "ProxyTakenOver";
    static final String RELEASED = "ProxyReleased";

    /** What a plan is told of motion commands: none of it comes from a boat that has no command. */
    public static final Set<String> OF_COMMANDS =
            Set.of(PATH_COMPLETED, PATH_FAILED, LIST_COMPLETED, BLOCK_DONE, PANORAMA_TAKEN, PANORAMA_FAILED);

    private EventNames() {}

    /** The event that says that a battery is of a class. */
    static String of(BatteryLevel level) {
        return switch (level) {
            case NOMINAL -> BATTERY_NOMINAL;
            case LOW -> BATTERY_LOW;
            case CRITICAL -> BATTERY_CRITICAL;
        };
    }
}
