package org.sami.crw.mavlink;

import java.util.List;
import org.sami.spn.value.GeoPoint;

/** A vehicle on which faults are tried, as {@link FaultCourse} needs it. For one thread. */
interface FaultyVehicle {
    /** Its name in a base. */
    String name();

    /** Its address for a base. */
    String address();

    /** The path that it is given. */
    List<GeoPoint> path();

    /** It, or its link, goes no further than to the beginning of a phase: part of an upload, an order that is not carried out. */
    void holdAt(FaultCase.Phase phase);

    /** Whether it has come as far as it is held. */
    boolean isHeld();

    /** It goes on from where it is held. */
    void letOn();

    /** A fault begins, but for the death of the base. */
    void begin(FaultCase.Fault fault) throws Exception;

    /** A fault is over. */
    void end(FaultCase.Fault fault) throws Exception;

    /** Nothing that a base says reaches it from now on, as if that had died; or it hears again. */
    void deaf(boolean now);

    /** Whether its motors may turn. */
    boolean isArmed();

    /** Whether its own checks before arming pass, as it says; its operator sends it nowhere before. */
    boolean isReady();

    /** How often it was armed in this case. */
    int armings();

    /** How many whole missions it has taken in this case. */
    int uploads();

    /** Returns once it lies still; from now on {@link #movedM} and {@link #assertLiesStill} count from here. */
    void markPlace();

    /** How far it has moved since its place was marked, in metres. */
    double movedM();

    /** Fails if it has moved by itself since its place was marked. */
    void assertLiesStill();

    /** How many places of its path it has passed, each counted as often as it was passed. */
    int visits();

    /** Fails if it has not passed each place of its path once, in their order, and near enough. */
    void assertVisitedOnceInOrder();
}
