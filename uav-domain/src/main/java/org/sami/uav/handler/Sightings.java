package org.sami.uav.handler;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.spn.value.GeoPoint;

/**
 * What the detectors of all aircraft report: readings of the channel {@link #CHANNEL} with three values, the target's number, latitude and longitude. A
 * target is the same for every aircraft that sees it. For the fleet's thread.
 */
final class Sightings implements Consumer<FleetEvent> {
    static final String CHANNEL = "target";

    private static final int VALUES = 3;

    private final List<Listener> listeners = new ArrayList<>();

    /** Hears of each report, also of a target that was seen before. */
    @FunctionalInterface
    interface Listener {
        void onTarget(String aircraft, int number, GeoPoint at);
    }

    void listen(Listener listener) {
        listeners.add(listener);
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.Measured measured && isTarget(measured.reading())) {
            List<Double> values = measured.reading().values();
            int number = (int) Math.round(values.get(0));
            GeoPoint at = GeoPoint.of(values.get(1), values.get(2));
            listeners.forEach(listener -> listener.onTarget(measured.boat(), number, at));
        }
    }

    private static boolean isTarget(BoatReading reading) {
        return reading.channel().equals(CHANNEL)
                && reading.values().size() == VALUES
                && Math.abs(reading.values().get(1)) <= 90
                && Math.abs(reading.values().get(2)) <= 180;
    }
}
