package org.sami.boat.app.phone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import android.Manifest;
import android.app.Application;
import android.content.Context;
import android.hardware.Sensor;
import android.hardware.SensorEvent;
import android.hardware.SensorManager;
import android.location.Location;
import android.location.LocationManager;
import android.os.SystemClock;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.SensorEventBuilder;
import org.robolectric.shadows.ShadowApplication;
import org.robolectric.shadows.ShadowLocationManager;
import org.robolectric.shadows.ShadowLooper;
import org.robolectric.shadows.ShadowSensor;
import org.robolectric.shadows.ShadowSensorManager;
import org.sami.boat.hull.position.Pose;
import org.sami.boat.hull.position.PositionDoubt;
import org.sami.boat.hull.position.PositionFilter;

/** The phone's position sensors, with and without permission. */
@RunWith(RobolectricTestRunner.class)
public class PhonePositionTest {
    private static final double LAT = 45.6;
    private static final double LON = 10.6;

    private final Application phone = RuntimeEnvironment.getApplication();
    private final ShadowApplication app = Shadow.extract(phone);
    private final ShadowLocationManager gps =
            Shadow.extract((LocationManager) phone.getSystemService(Context.LOCATION_SERVICE));
    private final ShadowSensorManager sensors =
            Shadow.extract((SensorManager) phone.getSystemService(Context.SENSOR_SERVICE));
    private final PositionFilter filter = new PositionFilter();
    private final PhonePosition position = new PhonePosition(phone, filter, SystemClock::elapsedRealtime);

    private Pose pose() {
        return filter.pose(SystemClock.elapsedRealtime());
    }

    private void fix() {
        Location at = new Location(LocationManager.GPS_PROVIDER);
        at.setLatitude(LAT);
        at.setLongitude(LON);
        at.setAccuracy(2);
        at.setSpeed(0);
        at.setTime(1_700_000_000_000L);
        at.setElapsedRealtimeNanos(SystemClock.elapsedRealtimeNanos());
        gps.simulateLocation(at);
        ShadowLooper.idleMainLooper();
    }

    @Test
    public void positionThatIsDeniedComesOnceItIsAllowed() {
        gps.setProviderEnabled(LocationManager.GPS_PROVIDER, true);
        app.denyPermissions(Manifest.permission.ACCESS_FINE_LOCATION);
        assertThat(position.begin()).isFalse();
        fix();
        assertThat(pose().isLocated()).isFalse();

        app.grantPermissions(Manifest.permission.ACCESS_FINE_LOCATION);
        assertThat(position.begin()).isTrue();
        fix();
        assertThat(pose().latDeg()).isCloseTo(LAT, within(1e-6));

        position.end();
    }

    @Test
    public void compassIsTurnedToTrueNorthWhereTheFixIs() {
        gps.setProviderEnabled(LocationManager.GPS_PROVIDER, true);
        app.grantPermissions(Manifest.permission.ACCESS_FINE_LOCATION);
        Sensor compass = ShadowSensor.newInstance(Sensor.TYPE_ROTATION_VECTOR);
        sensors.addSensor(compass);
        position.begin();
        fix();

        // a quarter turn to starboard about the axis that points up, as Android counts: minus 90 degrees
        SensorEvent event = SensorEventBuilder.newBuilder()
                .setSensor(compass)
                .setValues(new float[] {0, 0, (float) -Math.sin(Math.PI / 4), (float) Math.cos(Math.PI / 4)})
                .build();
        sensors.sendSensorEventToListeners(event, compass);

        assertThat(Math.toDegrees(pose().headingRad()))
                .as("east, and 2 to 5° of declination at Lake Garda")
                .isBetween(92.0, 95.0);
        assertThat(filter.doubts(SystemClock.elapsedRealtime())).doesNotContain(PositionDoubt.NO_COMPASS);
        position.end();
    }

    @Test
    public void phoneWithoutCompassBeginsAllTheSame() {
        gps.setProviderEnabled(LocationManager.GPS_PROVIDER, true);
        app.grantPermissions(Manifest.permission.ACCESS_FINE_LOCATION);

        assertThat(position.begin()).isTrue();
        assertThat(filter.doubts(SystemClock.elapsedRealtime())).contains(PositionDoubt.NO_COMPASS);
        position.end();
    }
}
