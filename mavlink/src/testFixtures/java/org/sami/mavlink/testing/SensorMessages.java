package org.sami.mavlink.testing;

import io.dronefleet.mavlink.ardupilotmega.CameraFeedback;
import io.dronefleet.mavlink.ardupilotmega.Rangefinder;
import io.dronefleet.mavlink.ardupilotmega.WaterDepth;
import io.dronefleet.mavlink.ardupilotmega.Wind;
import io.dronefleet.mavlink.common.CameraTrackingGeoStatus;
import io.dronefleet.mavlink.common.CameraTrackingStatusFlags;
import io.dronefleet.mavlink.common.DistanceSensor;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.NamedValueFloat;
import io.dronefleet.mavlink.common.NamedValueInt;
import io.dronefleet.mavlink.common.RadioStatus;
import java.math.BigInteger;

/** Messages with values of a vehicle's sensors and of its radio, for {@link SmallBoat#sends}. */
public final class SensorMessages {
    private SensorMessages() {}

    /** A value under a name of at most 10 characters. */
    public static Object named(String name, double value) {
        return NamedValueFloat.builder().name(name).value((float) value).build();
    }

    /** A whole number under a name of at most 10 characters. */
    public static Object named(String name, int value) {
        return NamedValueInt.builder().name(name).value(value).build();
    }

    /** What a depth sounder that looks down measures: metres, and degrees Celsius. */
    public static Object water(double depthM, double temperatureC) {
        return WaterDepth.builder()
                .healthy(1)
                .distance((float) depthM)
                .temperature((float) temperatureC)
                .build();
    }

    /** How far something before a sensor is, in whole centimetres. */
    public static Object distance(int centimetres) {
        return DistanceSensor.builder().currentDistance(centimetres).build();
    }

    /** A camera has taken a picture, the so many-th, at a place in degrees. */
    public static Object picture(int number, double latDeg, double lonDeg) {
        return CameraFeedback.builder()
                .timeUsec(BigInteger.ZERO)
                .imgIdx(number)
                .lat((int) Math.round(latDeg * 1e7))
                .lng((int) Math.round(lonDeg * 1e7))
                .build();
    }

    /** A camera follows a target at a place, in degrees. */
    public static Object target(double latDeg, double lonDeg) {
        return CameraTrackingGeoStatus.builder()
                .trackingStatus(CameraTrackingStatusFlags.CAMERA_TRACKING_STATUS_FLAGS_ACTIVE)
                .lat((int) Math.round(latDeg * 1e7))
                .lon((int) Math.round(lonDeg * 1e7))
                .build();
    }

    /** Where a vehicle is, in degrees, so many milliseconds after its autopilot's start. */
    public static Object position(double latDeg, double lonDeg, int sinceBootMs) {
        return GlobalPositionInt.builder()
                .timeBootMs(sinceBootMs)
                .lat((int) Math.round(latDeg * 1e7))
                .lon((int) Math.round(lonDeg * 1e7))
                .build();
    }

    /** What a radio on the way reports of itself: how strong its signal is here, as it counts. */
    public static Object radio(int strength) {
        return RadioStatus.builder().rssi(strength).remrssi(strength).build();
    }

    /** The wind that an autopilot estimates: from where it comes, in degrees, and how strong it is, in m/s. */
    public static Object wind(double fromDeg, double mps) {
        return Wind.builder().direction((float) fromDeg).speed((float) mps).build();
    }

    /** What a depth sounder or rangefinder measures, in metres. */
    public static Object range(double metres) {
        return Rangefinder.builder().distance((float) metres).build();
    }
}
