package org.sami.crw.mavlink;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.SensorReport;

/**
 * What a vehicle measures, as far as it has reported it since this program began: autopilots do not list their sensors. Until the first value nothing is said. For
 * the gateway's thread.
 */
final class VehicleSensors {
    private final Set<String> channels = new TreeSet<>();

    /** Takes a value; whether its channel is one that was not known before. */
    boolean isNew(SensorReport report) {
        return channels.size() < BoatCapabilities.MOST_CHANNELS
                && channels.add(report.sensor() + "/" + report.channel());
    }

    /** The channels, each as {@code sensor/channel}; empty where nothing was reported yet. */
    Optional<List<String>> channels() {
        return channels.isEmpty() ? Optional.empty() : Optional.of(List.copyOf(channels));
    }
}
