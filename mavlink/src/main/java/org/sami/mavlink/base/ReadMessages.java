package org.sami.mavlink.base;

import io.dronefleet.mavlink.ardupilotmega.CameraFeedback;
import io.dronefleet.mavlink.ardupilotmega.EkfStatusReport;
import io.dronefleet.mavlink.ardupilotmega.Rangefinder;
import io.dronefleet.mavlink.ardupilotmega.WaterDepth;
import io.dronefleet.mavlink.ardupilotmega.Wind;
import io.dronefleet.mavlink.common.AutopilotVersion;
import io.dronefleet.mavlink.common.CameraTrackingGeoStatus;
import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.DistanceSensor;
import io.dronefleet.mavlink.common.FenceStatus;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.GpsRawInt;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionCurrent;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionItemReached;
import io.dronefleet.mavlink.common.MissionRequest;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.NamedValueFloat;
import io.dronefleet.mavlink.common.NamedValueInt;
import io.dronefleet.mavlink.common.ParamValue;
import io.dronefleet.mavlink.common.RcChannels;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.minimal.Heartbeat;
import java.util.Set;

/** The kinds of messages that a base reads: all that the classes in vehicle, command, mission and param look at. Others are only counted. */
final class ReadMessages {
    @SuppressWarnings("deprecation") // ArduPilot asks for items with MissionRequest
    static final Set<Class<?>> KINDS = Set.of(
            AutopilotVersion.class,
            Heartbeat.class,
            GlobalPositionInt.class,
            SysStatus.class,
            GpsRawInt.class,
            EkfStatusReport.class,
            FenceStatus.class,
            Statustext.class,
            NamedValueFloat.class,
            NamedValueInt.class,
            WaterDepth.class,
            DistanceSensor.class,
            Rangefinder.class,
            Wind.class,
            CameraFeedback.class,
            CameraTrackingGeoStatus.class,
            CommandAck.class,
            MissionCurrent.class,
            MissionItemReached.class,
            MissionRequest.class,
            MissionRequestInt.class,
            MissionCount.class,
            MissionItemInt.class,
            MissionAck.class,
            ParamValue.class,
            RcChannels.class);

    private ReadMessages() {}
}
