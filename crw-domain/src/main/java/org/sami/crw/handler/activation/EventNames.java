package org.sami.crw.handler.activation;

import java.util.Set;
import org.sami.boat.link.BatteryLevel;

/** The input events by which handlers answer, as the domain's vocabulary names them. */
public final class EventNames {
    public static final String PATH_COMPLETED = "ProxyPathCompleted";
    public static final String PATH_FAILED = "ProxyPathFailed";
    public static final String LIST_COMPLETED = "ProxyListCompleted";
    public static final String BLOCK_DONE = "BlockMovementDone";
    public static final String ENTERED_AREA = "ProxyEnteredArea";
    public static final String LEFT_AREA = "ProxyLeftArea";
    public static final String PANORAMA_TAKEN = "PanoramaTaken";
    public static final String PANORAMA_FAILED = "PanoramaFailed";
    public static final String MEASUREMENT_TAKEN = "MeasurementTaken";
    public static final String MEASUREMENT_FAILED = "MeasurementFailed";
    public static final String GAINS_SUCCEEDED = "SetGainsSucceeded";
    public static final String GAINS_FAILED = "SetGainsFailed";
    public static final String MULTIPLIER_SUCCEEDED = "SetVelocityMultiplierSucceeded";
    public static final String MULTIPLIER_FAILED = "SetVelocityMultiplierFailed";
    public static final String ALLOCATION_RESPONSE = "AllocationResponse";
    public static final String PATH_RESPONSE = "PathResponse";
    public static final String DISTRIBUTE_RESPONSE = "DistributeLocationsResponse";
    public static final String ASSEMBLE_RESPONSE = "AssembleLocationResponse";
    public static final String QUANTITY_GREATER = "QuantityGreater";
    public static final String QUANTITY_LESS = "QuantityLess";
    public static final String QUANTITY_EQUAL = "QuantityEqual";
    public static final String PROXY_CREATED = "ProxyCreated";
    public static final String PROXY_CONNECTED = "ProxyConnected";
    /** Answer to Task Complete. */
    public static final String TASK_COMPLETED = "TaskCompleted";

    public static final String POSE_UPDATED = "ProxyPoseUpdated";
    /** News of a battery. */
    public static final String BATTERY_NOMINAL = "BatteryNominal";
    /** News of a battery. */
    public static final String BATTERY_LOW = "BatteryLow";
    /** News of a battery. */
    public static final String BATTERY_CRITICAL = "BatteryCritical";

    public static final String PROXY_ABORTED = "ProxyAbortMissionReceived";
    public static final String TAKEN_OVER = "ProxyTakenOver";
    public static final String RELEASED = "ProxyReleased";

    /** Which outcomes of motion commands reach a plan: none of it comes from a boat that has no command. */
    public static final Set<String> OF_COMMANDS =
            Set.of(PATH_COMPLETED, PATH_FAILED, LIST_COMPLETED, BLOCK_DONE, PANORAMA_TAKEN, PANORAMA_FAILED);

    /** The answers that report to a plan that its request has failed. */
    public static final Set<String> OF_FAILURES =
            Set.of(PATH_FAILED, PANORAMA_FAILED, MEASUREMENT_FAILED, GAINS_FAILED, MULTIPLIER_FAILED);

    private EventNames() {}

    /** The event that says that a battery is of a class. */
    public static String of(BatteryLevel level) {
        return switch (level) {
            case NOMINAL -> BATTERY_NOMINAL;
            case LOW -> BATTERY_LOW;
            case CRITICAL -> BATTERY_CRITICAL;
        };
    }
}
