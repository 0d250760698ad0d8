package org.sami.mavlink.onboard;

import java.util.List;
import org.sami.mavlink.vehicle.VehicleId;

/** The vehicle behind an onboard end: says how it is, and decides what it does. Called on the thread that owns the end. */
public interface OnboardHost extends ListKeeper {
    /** How the vehicle is now. */
    OnboardState state();

    /** A ground station said something to this vehicle, or that it is there. */
    void heard(VehicleId station);

    /** Carries out an order, or refuses it. */
    OrderReply order(VehicleId station, StationOrder order);

    /** All parameters, always in the same order. */
    List<OnboardParameter> parameters();

    /** Sets a parameter that exists, or refuses to. */
    OrderReply setParameter(VehicleId station, String name, double value);
}
