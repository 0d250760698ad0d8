package org.sami.boat.app.phone;

import android.Manifest;
import android.content.Context;
import android.content.pm.PackageManager;
import android.hardware.GeomagneticField;
import android.hardware.Sensor;
import android.hardware.SensorEvent;
import android.hardware.SensorEventListener;
import android.hardware.SensorManager;
import android.location.Location;
import android.location.LocationListener;
import android.location.LocationManager;
import android.os.Bundle;
import android.os.Looper;
import java.util.function.LongSupplier;
import org.sami.boat.hull.position.GpsFix;
import org.sami.boat.hull.position.PositionFilter;

/**
 * GPS, compass and gyro of the phone, for a position filter. The phone lies flat in its box, its top towards the bow. Without permission for the position it
 * begins with compass and gyro; {@link #begin} again adds the GPS once the permission is there. For the main thread.
 */
public final class PhonePosition {
    private static final long GPS_PERIOD_MS = 200;
    private static final int SENSOR_PERIOD_US = 20_000;
    private static final long DECLINATION_PERIOD_MS = 60_000;

    private final Context context;
    private final PositionFilter filter;
    private final LongSupplier clock;
    private final LocationManager locations;
    private final SensorManager sensors;
    private final Gps gps = new Gps();
    private final Motion motion = new Motion();
    private boolean gpsBegun;
    private boolean motionBegun;

    /**
     * Sensors that are not asked yet.
     *
     * @param clock the filter's, in ms
     */
    public PhonePosition(Context context, PositionFilter filter, LongSupplier clock) {
        this.context = context;
        this.filter = filter;
        this.clock = clock;
        locations = (LocationManager) context.getSystemService(Context.LOCATION_SERVICE);
        sensors = (SensorManager) context.getSystemService(Context.SENSOR_SERVICE);
    }

    /** Begins what has not begun yet; whether all that the phone has is asked now. */
    public boolean begin() {
        if (!motionBegun) {
            motionBegun = true;
            listen(Sensor.TYPE_ROTATION_VECTOR);
            listen(Sensor.TYPE_GYROSCOPE);
        }
        if (!gpsBegun
                && context.checkSelfPermission(Manifest.permission.ACCESS_FINE_LOCATION)
                        == PackageManager.PERMISSION_GRANTED
                && locations.getAllProviders().contains(LocationManager.GPS_PROVIDER)) {
            locations.requestLocationUpdates(
                    LocationManager.GPS_PROVIDER, GPS_PERIOD_MS, 0, gps, Looper.getMainLooper());
            gpsBegun = true;
        }
        return gpsBegun;
    }

    private void listen(int type) {
        Sensor sensor = sensors.getDefaultSensor(type);
        if (sensor != null) { // without one the filter says so
            sensors.registerListener(motion, sensor, SENSOR_PERIOD_US);
        }
    }

    /** Ends all. */
    public void end() {
        locations.removeUpdates(gps);
        sensors.unregisterListener(motion);
        gpsBegun = false;
        motionBegun = false;
    }

    /** What the GPS says. */
    private final class Gps implements LocationListener {
        private long declinationMs = Long.MIN_VALUE / 2;

        @Override
        public void onLocationChanged(Location at) {
            long nowMs = clock.getAsLong();
            if (nowMs - declinationMs >= DECLINATION_PERIOD_MS) {
                declinationMs = nowMs;
                filter.setDeclination(declinationRad(at));
            }
            filter.gps(
                    new GpsFix(
                            at.getLatitude(),
                            at.getLongitude(),
                            at.hasAccuracy() ? at.getAccuracy() : Double.NaN,
                            at.hasSpeed() ? at.getSpeed() : Double.NaN,
                            at.hasBearing() ? Math.toRadians(at.getBearing()) : Double.NaN),
                    nowMs);
        }

        /** By the phone's own model of the Earth's field, for the date of the satellites: the phone's may be wrong. */
        private double declinationRad(Location at) {
            return Math.toRadians(new GeomagneticField(
                            (float) at.getLatitude(), (float) at.getLongitude(), (float) at.getAltitude(), at.getTime())
                    .getDeclination());
        }

        @Override
        public void onStatusChanged(String provider, int status, Bundle extras) {
            // what counts is whether fixes come
        }

        @Override
        public void onProviderEnabled(String provider) {
            // fixes come again by themselves
        }

        @Override
        public void onProviderDisabled(String provider) {
            // the filter notices that no fixes come
        }
    }

    /** What compass and gyro say. */
    private final class Motion implements SensorEventListener {
        private final float[] rotation = new float[9];
        private final float[] angles = new float[3];

        @Override
        public void onSensorChanged(SensorEvent event) {
            long nowMs = clock.getAsLong();
            if (event.sensor.getType() == Sensor.TYPE_GYROSCOPE) {
                filter.gyro(-event.values[2], nowMs); // Android counts to port, seen from above
            } else {
                SensorManager.getRotationMatrixFromVector(rotation, event.values);
                filter.compass(SensorManager.getOrientation(rotation, angles)[0], nowMs);
            }
        }

        @Override
        public void onAccuracyChanged(Sensor sensor, int accuracy) {
            // the filter finds out by itself how far compass and course disagree
        }
    }
}
