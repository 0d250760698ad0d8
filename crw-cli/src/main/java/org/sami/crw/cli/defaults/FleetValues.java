package org.sami.crw.cli.defaults;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.boat.link.BatteryDefaults;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LinkDefaults;
import org.sami.boat.link.MotionDefaults;
import org.sami.boat.link.PhoneReadings;
import org.sami.boat.server.BoatServerDefaults;
import org.sami.crw.handler.planning.ServiceThreads;
import org.sami.crw.handler.subscription.MeasurementHandler;
import org.sami.crw.manipulation.ManipulationPolicy;
import org.sami.crw.operator.StuckWatch;
import org.sami.crw.operator.alarm.AlarmLimits;
import org.sami.crw.proxy.execution.CommandDefaults;
import org.sami.crw.proxy.link.BaseDefaults;
import org.sami.crw.service.path.PathProblem;
import org.sami.crw.service.reach.Endurance;
import org.sami.crw.service.reach.Range;
import org.sami.crw.service.reach.WayBack;
import org.sami.crw.service.reach.WayCheck;
import org.sami.crw.session.SessionDefaults;
import org.sami.crw.session.fault.HealthDefaults;
import org.sami.spn.engine.Engine;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.suggestion.SuggestionRequest;

/** The numbers of boats, their base, services, warnings and the engine. */
final class FleetValues {
    private FleetValues() {}

    static List<DefaultValue> all() {
        return Stream.of(boats(), links(), commands(), planning(), warnings(), engine(), suggestions())
                .flatMap(subject -> subject.values().stream())
                .toList();
    }

    private static SubjectDefaults boats() {
        String settings = "the boat's settings in the operator's window";
        return new SubjectDefaults("Boats")
                .text(
                        "lost-link action",
                        LinkDefaults.LOST_LINK_ACTION.name().toLowerCase(Locale.ROOT),
                        "",
                        "What a boat does when the link to its commander is lost.",
                        "crw boat --lost-link; " + settings)
                .number(
                        "cruise speed",
                        MotionDefaults.CRUISE_SPEED_MPS,
                        "m/s",
                        "Speed along paths that name none, and on ways home.")
                .number(
                        "speed at full thrust",
                        MotionDefaults.FULL_THRUST_SPEED_MPS,
                        "m/s",
                        "Speed in still water at full thrust, from which the boat works out its thrust.",
                        "crw boat --top-speed")
                .text(
                        "heading gains",
                        gains(BoatServerDefaults.HEADING_GAINS),
                        "",
                        "Proportional, integral and derivative gain of the heading loop.",
                        settings)
                .text(
                        "speed gains",
                        gains(BoatServerDefaults.SPEED_GAINS),
                        "",
                        "Proportional, integral and derivative gain of the speed loop.",
                        settings)
                .number(
                        "arrival radius",
                        MotionDefaults.ARRIVAL_RADIUS_M,
                        "m",
                        "A boat within this distance of a location has reached it.")
                .number(
                        "hold radius",
                        MotionDefaults.HOLD_RADIUS_M,
                        "m",
                        "A boat that holds its place drifts this far before it drives back.")
                .number(
                        "separation",
                        MotionDefaults.SEPARATION_M,
                        "m",
                        "Distance that boats keep from each other; paths leave room for it.")
                .number("braking", MotionDefaults.BRAKING_MPS2, "m/s²", "How fast a boat slows down before corners.")
                .number("battery low", BatteryDefaults.LOW_PERCENT, "%", "Below this charge a battery is low.")
                .number(
                        "battery critical",
                        BatteryDefaults.CRITICAL_PERCENT,
                        "%",
                        "Below this charge a battery is critical at any place.")
                .number(
                        "reserve for the way home",
                        BatteryDefaults.HOME_RESERVE_FACTOR,
                        "",
                        "A battery is critical where its charge is less than this many times what the way home takes.")
                .number(
                        "battery changed",
                        BatteryDefaults.RECHARGED_PERCENT,
                        "%",
                        "A charge that rises by this much means a new or charged battery.")
                .number(
                        "longest waypoint list",
                        BoatServerDefaults.MAX_WAYPOINTS,
                        "",
                        "Most waypoints that a boat takes.")
                .number(
                        "size of the log",
                        BoatServerDefaults.LOG_BYTES >> 20,
                        "MiB",
                        "Most that a boat keeps of its log, over all of its files.",
                        "crw boat --log-size; the settings on the boat's phone");
    }

    private static String gains(Gains gains) {
        return gains.proportional() + " " + gains.integral() + " " + gains.derivative();
    }

    private static SubjectDefaults links() {
        return new SubjectDefaults("Links")
                .millis(
                        "link lost",
                        LinkDefaults.LINK_LOST_AFTER_MS,
                        "A link is lost after this time without a frame, on both sides; what is known of a boat is"
                                + " stale then.")
                .millis("heartbeat", LinkDefaults.HEARTBEAT_MS, "Each side sends a frame at least this often.")
                .millis(
                        "teleoperation stop",
                        LinkDefaults.TELEOPERATION_STOP_MS,
                        "The motors stop after this time without a new command of teleoperation.")
                .number(
                        "telemetry of a session",
                        SessionDefaults.TELEMETRY_HZ,
                        "Hz",
                        "Telemetry messages that a session over TCP asks of each boat.")
                .number(
                        "telemetry",
                        LinkDefaults.TELEMETRY_HZ,
                        "Hz",
                        "Telemetry messages to a client that asks for no other rate.")
                .millis("resend", BaseDefaults.RESEND_MS, "An unanswered request is sent again after this time.")
                .number("sends", BaseDefaults.MAX_SENDS, "", "An unanswered request is given up after this many sends.")
                .number(
                        "losses of a flapping link",
                        BaseDefaults.FLAPPING_LOSSES,
                        "",
                        "A link that was lost this often within the time below flaps.")
                .millis("time for flapping", BaseDefaults.FLAPPING_WINDOW_MS, "Losses are counted for this time.")
                .millis(
                        "boat not reached",
                        SessionDefaults.UNREACHED_AFTER_MS,
                        "A boat that has not answered for this time is a fault of the session.");
    }

    private static SubjectDefaults commands() {
        return new SubjectDefaults("Commands")
                .number("tries", CommandDefaults.MAX_TRIES, "", "A command that fails is tried this often.")
                .millis(
                        "no progress shown",
                        CommandDefaults.NO_PROGRESS_SHOWN_AFTER_MS,
                        "A boat that comes no nearer to its waypoint for this time is shown to the operator.")
                .millis(
                        "no progress failed",
                        CommandDefaults.NO_PROGRESS_FAILED_AFTER_MS,
                        "A path without progress for this time has failed.")
                .millis(
                        "panorama",
                        CommandDefaults.LONGEST_PANORAMA_MS,
                        "A panorama that is not complete after this time is taken again.")
                .number(
                        "place of a failed path",
                        CommandDefaults.PLACE_RADIUS_M,
                        "m",
                        "A boat whose path has failed stays within this distance of its place.")
                .millis(
                        "measurement",
                        MeasurementHandler.FAILED_AFTER_MS,
                        "A measurement fails after this time without a reading.");
    }

    private static SubjectDefaults planning() {
        return new SubjectDefaults("Planning")
                .number(
                        "range",
                        Range.METRES_PER_PERCENT,
                        "m",
                        "Mean distance that one percent of charge takes a boat which does not say it; simulated boats"
                                + " drive as far without --range.")
                .number(
                        "costliest metre",
                        Range.COSTLIEST_METRE,
                        "",
                        "A charge is sure to last for a way whose metres cost this many times the mean.")
                .number(
                        "charge at home",
                        WayBack.PLENTY_PERCENT,
                        "%",
                        "A boat that would bring less charge home is named before it starts.")
                .number(
                        "time in the air",
                        Endurance.USUAL_S,
                        "s",
                        "A full battery is assumed to keep a copter in the air so long, until it was seen of that copter.")
                .number(
                        "charge to land with",
                        Endurance.LANDING_PERCENT,
                        "%",
                        "The operator is asked before a copter flies that would land at home with less.")
                .number("far point", WayCheck.FAR_M, "m", "The operator is asked about points farther away than this.")
                .number(
                        "detour",
                        PathProblem.DETOUR,
                        "",
                        "A path may be this many times the shortest one to keep its clearance.",
                        "plan: PathRequest.detour")
                .millis(
                        "computation of a service",
                        ServiceThreads.STANDARD_LIMIT_MILLIS,
                        "A computation of paths, areas or allocations is given up after this time.");
    }

    private static SubjectDefaults warnings() {
        return new SubjectDefaults("Warnings")
                .millis(
                        "position stale",
                        AlarmLimits.POSITION_STALE_AFTER_MS,
                        "A linked boat has said nothing of its position for this time.")
                .number(
                        "drift without a command",
                        AlarmLimits.DRIFT_WITHOUT_COMMAND_M,
                        "m",
                        "A boat that nobody commands drifts when it is carried farther than this.")
                .number(
                        "drift from a station",
                        AlarmLimits.DRIFT_OUTSIDE_STATION_M,
                        "m",
                        "A boat drifts when it is farther than this outside the circle of its station.")
                .millis("drift time", AlarmLimits.DRIFT_AFTER_MS, "It has to be out there for this time.")
                .number(
                        "phone hot",
                        PhoneReadings.HOT_C,
                        "°C",
                        "A boat's phone that is as hot may soon switch itself off.")
                .number(
                        "phone storage",
                        PhoneReadings.LITTLE_STORAGE_MB,
                        "MB",
                        "A boat's phone with less free storage will soon write no log.")
                .number(
                        "approach",
                        AlarmLimits.APPROACH_M,
                        "m",
                        "Boats that are about to come closer than this to each other.")
                .number(
                        "approach time",
                        AlarmLimits.APPROACH_WITHIN_S,
                        "s",
                        "They will be that close within this time.")
                .number(
                        "depth in a no-go area",
                        AlarmLimits.NO_GO_DEPTH_M,
                        "m",
                        "A boat that seems to be deeper than this in what its mission avoids.")
                .number(
                        "path in a no-go area",
                        AlarmLimits.NO_GO_PATH_DEPTH_M,
                        "m",
                        "A path that leads deeper than this into it.")
                .number("position jumps", AlarmLimits.FASTEST_MPS, "m/s", "A position that moves faster has jumped.")
                .millis(
                        "position frozen",
                        AlarmLimits.FROZEN_AFTER_MS,
                        "A position that stays the same for this time while the boat moves.")
                .number(
                        "wrong course",
                        AlarmLimits.WRONG_COURSE_DEG,
                        "°",
                        "A heading that differs from the course by more than this is doubtful.")
                .millis(
                        "change of a panel",
                        ManipulationPolicy.COOLDOWN_MILLIS,
                        "An event that limits its frequency changes a panel again after this time.")
                .millis(
                        "panel in use",
                        ManipulationPolicy.IN_USE_MILLIS,
                        "With timed suppress, events leave a panel alone for this time after the operator used it.")
                .millis(
                        "mission stuck",
                        StuckWatch.SETTLED_MILLIS,
                        "A mission that cannot go on by itself for this time is stuck.")
                .number(
                        "disk low",
                        HealthDefaults.ROOM_LOW_MIN,
                        "min",
                        "The journal's disk will be full within this time, or has less room than below.")
                .number("disk low, room", HealthDefaults.ROOM_LOW_BYTES / 1048576.0, "MiB", "Room for that warning.")
                .number("disk full", HealthDefaults.ROOM_GONE_MIN, "min", "As before, as a fault instead of a warning.")
                .number("disk full, room", HealthDefaults.ROOM_GONE_BYTES / 1048576.0, "MiB", "Room for that fault.")
                .number(
                        "memory full",
                        100 * HealthDefaults.MEMORY_FULL_SHARE,
                        "%",
                        "Share of its memory from which the program has nearly none left.");
    }

    private static SubjectDefaults engine() {
        return new SubjectDefaults("Engine and files")
                .number(
                        "livelock",
                        Engine.DEFAULT_LIVELOCK_LIMIT,
                        "",
                        "A mission that fires this often without new input is in a livelock, and is stopped.")
                .number(
                        "project file",
                        BoundedFile.PROJECT_BYTES / 1048576.0,
                        "MiB",
                        "Larger files of projects are refused.")
                .number("data file", BoundedFile.DATA_BYTES / 1048576.0, "MiB", "Larger files of data are refused.")
                .number(
                        "settings file",
                        BoundedFile.SETTINGS_BYTES / 1048576.0,
                        "MiB",
                        "Larger files of settings and answers are refused.");
    }

    private static SubjectDefaults suggestions() {
        return new SubjectDefaults("Suggestions at an edge")
                .text(
                        "teams",
                        SuggestionRequest.TEAMS.stream().map(String::valueOf).collect(Collectors.joining(", ")),
                        "",
                        "Numbers of robots with which each set of requirements is tried, in this order.",
                        DefaultValue.NOWHERE)
                .number(
                        "states of a search",
                        SuggestionRequest.STATES_PER_SEARCH,
                        "",
                        "States that one search of one set of requirements looks at.")
                .number(
                        "states of all searches",
                        SuggestionRequest.ALL_STATES,
                        "",
                        "States that all searches for one edge look at together.");
    }
}
