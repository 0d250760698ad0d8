package org.sami.crw.mavlink;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.mavlink.link.MavlinkLink;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * Names the person who has changed a vehicle's state: a pilot by radio control, or another ground station by its system id. What shows it is an answer of the vehicle
 * to that station, what its radio control does, and which stations are heard. Names both where none of these decides. For the gateway's thread.
 */
final class RadioOrStation {
    private static final long OBEYED_MS = 4_000;
    private static final int OWN_ID = MavlinkLink.GROUND_SYSTEM;

    private final RadioControl radio;
    private Optional<Integer> obeyed = Optional.empty(); // the station that it has obeyed last
    private long obeyedMs;
    private boolean certain = true; // the last answer
    private long changedMs = Long.MIN_VALUE / 2;
    private long armedMs = Long.MIN_VALUE / 2;
    private long disarmedMs = Long.MIN_VALUE / 4;

    RadioOrStation(RadioControl radio) {
        this.radio = radio;
    }

    /** The vehicle reports itself in another way than before. */
    void reported(VehicleSnapshot before, VehicleSnapshot now, long atMs) {
        changedMs = before.mode().equals(now.mode()) && before.armed() == now.armed() ? changedMs : atMs;
        armedMs = now.armed() && !before.armed() ? atMs : armedMs;
        disarmedMs = !now.armed() && before.armed() ? atMs : disarmedMs;
    }

    /** Something happened to the vehicle; whether it tells more of who controls it. */
    boolean happened(VehicleEvent event, long atMs) {
        if (event instanceof VehicleEvent.RadioHeard heard) {
            radio.heard(heard.pulsesUs(), atMs);
            return true;
        } else if (event instanceof VehicleEvent.ObeyedStation station) {
            obeyed = Optional.of(station.station());
            obeyedMs = atMs;
            return true;
        }
        return false;
    }

    /** Who it is, in words for the operator. */
    String who(VehicleSnapshot vehicle, long atMs) {
        Optional<Integer> station = obeyed.filter(one -> atMs - obeyedMs <= OBEYED_MS);
        boolean isArming = armedMs == changedMs;
        certain = true;
        if (station.isPresent()) {
            return stations(List.of(station.get()));
        } else if (radio.hasActed(vehicle, isArming, atMs)) {
            return "a pilot's radio control";
        }
        boolean isDisarming = disarmedMs == changedMs; // which the mode switch tells nothing of
        boolean isStation =
                radio.isNotReceived(changedMs) || (!isDisarming && radio.isRuledOut(vehicle, isArming, changedMs));
        certain = isStation;
        if (vehicle.stations().isEmpty()) {
            return isStation ? "a ground station that is not heard here" : "a pilot or another ground station";
        }
        String heard = stations(vehicle.stations());
        return isStation ? heard : "a pilot or " + heard;
    }

    /** Whether the last answer names one of both: it does not change by what is learned later. */
    boolean isCertain() {
        return certain;
    }

    private static String stations(List<Integer> ids) {
        return "ground station "
                + ids.stream()
                        .map(id -> id == OWN_ID ? id + " (not this base, which has the same id)" : id.toString())
                        .collect(Collectors.joining(" or "));
    }
}
