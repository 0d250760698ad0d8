package org.sami.mavlink.onboard;

import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.FileTransferProtocol;
import io.dronefleet.mavlink.common.ManualControl;
import io.dronefleet.mavlink.common.MissionClearAll;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequest;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import io.dronefleet.mavlink.common.MissionSetCurrent;
import io.dronefleet.mavlink.common.MissionWritePartialList;
import io.dronefleet.mavlink.common.ParamRequestList;
import io.dronefleet.mavlink.common.ParamRequestRead;
import io.dronefleet.mavlink.common.ParamSet;
import io.dronefleet.mavlink.common.Ping;
import io.dronefleet.mavlink.common.RcChannelsOverride;
import io.dronefleet.mavlink.common.RequestDataStream;
import io.dronefleet.mavlink.common.SetMode;
import io.dronefleet.mavlink.common.SetPositionTargetGlobalInt;
import io.dronefleet.mavlink.common.Timesync;
import java.util.Optional;

/**
 * For whom a message is.
 *
 * @param system a system id; 0 for all
 * @param component a component id; 0 for all
 */
record MessageTargets(int system, int component) {
    /** The target of a message that a vehicle acts on; empty for all others. */
    @SuppressWarnings("deprecation") // stations that are older ask by the older messages
    static Optional<MessageTargets> of(Object message) {
        if (message instanceof CommandLong it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof CommandInt it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof MissionItemInt it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof MissionRequestInt it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof MissionRequest it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof MissionRequestList it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof MissionCount it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof MissionClearAll it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof MissionWritePartialList it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof MissionSetCurrent it) {
            return of(it.targetSystem(), it.targetComponent());
        }
        return ofOthers(message);
    }

    @SuppressWarnings("deprecation")
    private static Optional<MessageTargets> ofOthers(Object message) {
        if (message instanceof ParamRequestList it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof ParamRequestRead it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof ParamSet it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof RequestDataStream it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof SetPositionTargetGlobalInt it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof RcChannelsOverride it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof ManualControl it) {
            return of(it.target(), 0);
        } else if (message instanceof SetMode it) {
            return of(it.targetSystem(), 0);
        } else if (message instanceof Ping it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof FileTransferProtocol it) {
            return of(it.targetSystem(), it.targetComponent());
        } else if (message instanceof Timesync it) {
            return of(it.targetSystem(), it.targetComponent());
        }
        return Optional.empty();
    }

    private static Optional<MessageTargets> of(int system, int component) {
        return Optional.of(new MessageTargets(system, component));
    }

    /** Whether it is for the autopilot of a system. */
    boolean isFor(int ownSystem, int ownComponent) {
        return (system == 0 || system == ownSystem) && (component == 0 || component == ownComponent);
    }
}
