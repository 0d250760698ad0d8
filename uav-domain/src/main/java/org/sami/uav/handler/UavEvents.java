package org.sami.uav.handler;

import java.util.Map;
import java.util.Set;
import org.sami.crw.handler.planning.BoatDemands.Demand;

/** The names of the domain's events that handlers take and post, as {@code events.json} has them. */
final class UavEvents {
    static final String TAKE_OFF = "TakeOff";
    static final String CLIMB_TO = "ClimbTo";
    static final String FLY_TO = "FlyTo";
    static final String FLY_PATH = "FlyPath";
    static final String HOVER = "Hover";
    static final String LAND = "Land";
    static final String RETURN_HOME = "ReturnHome";
    static final String LOOK_AROUND = "LookAround";
    static final String SEARCH_AROUND = "SearchAround";
    static final String FOLLOW = "Follow";
    static final String COMPUTE_ALLOCATIONS = "ComputeAllocations";
    static final String GIVE_BACK_TASKS = "GiveBackTasks";
    static final String PLAN_LANES = "PlanLanes";
    static final String WATCH_WIND = "WatchWind";
    static final String WATCH_TARGETS = "WatchTargets";

    /** Those of the events above that move aircraft. */
    static final Set<String> MOVES =
            Set.of(TAKE_OFF, CLIMB_TO, FLY_TO, FLY_PATH, HOVER, LAND, RETURN_HOME, LOOK_AROUND, SEARCH_AROUND, FOLLOW);

    /** Those of the events above that need more than flying: a camera, for a picture or for what it detects, or an estimate of the wind. */
    static final Map<String, Demand> DEMANDS = Map.of(
            LOOK_AROUND, Demand.PANORAMA,
            SEARCH_AROUND, Demand.TARGETS,
            WATCH_TARGETS, Demand.TARGETS,
            WATCH_WIND, Demand.WIND);

    static final String AIRBORNE = "Airborne";
    static final String ALTITUDE_REACHED = "AltitudeReached";
    static final String REACHED_LOCATION = "ReachedLocation";
    static final String PATH_FLOWN = "PathFlown";
    static final String HOVERING = "Hovering";
    static final String LANDED = "Landed";
    static final String PICTURE_TAKEN = "PictureTaken";
    static final String TARGET_SEEN = "TargetSeen";
    static final String TARGET_SIGHTED = "TargetSighted";
    static final String NOTHING_SEEN = "NothingSeen";
    static final String CANNOT_FLY = "CannotFly";
    static final String ALLOCATIONS_COMPUTED = "AllocationsComputed";
    static final String TASK_IMPOSSIBLE = "TaskImpossible";
    static final String TASKS_GIVEN_BACK = "TasksGivenBack";
    static final String LANES_PLANNED = "LanesPlanned";
    static final String WIND_STRONG = "WindStrong";
    static final String AIRCRAFT_LOST = "AircraftLost";
    static final String LINK_LOST = "LinkLost";
    static final String LINK_BACK = "LinkBack";

    private UavEvents() {}
}
