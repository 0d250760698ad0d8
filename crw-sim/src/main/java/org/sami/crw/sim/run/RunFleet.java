package org.sami.crw.sim.run;

import java.util.List;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.decision.OperatorDefaults;
import org.sami.crw.report.LinkResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.sim.run.record.BoatState;
import org.sami.crw.sim.run.record.ReportFolds;

/**
 * The boats of one run and how their time passes: simulated ones in this process on a virtual clock, or other processes over TCP in real time.
 * All else of a run is the same for both, and stands in {@link RunHarness}. For the engine's thread, unless stated otherwise.
 */
public interface RunFleet {
    /** In metres around the area's centre. */
    LocalFrame plane();

    /** The simulated operator's answers where no rule gives one. */
    OperatorDefaults operatorDefaults();

    /** The boats that interrupts may name, in the order in which they are counted. */
    List<String> names();

    /** Their present state: the true one of simulated boats, the last reported one of others. */
    List<BoatState> boats();

    /** How a boat's link went. */
    LinkResult link(String boat);

    /** Adds those parts of the report that this kind of fleet alone knows. */
    default void addTo(ReportFolds report) {}

    /** Looks which locations boats come to; several times a second. */
    void lookForVisits(long nowMillis);

    /** Looks where boats are; once a second. */
    void track(long nowMillis);

    /** Has the harness begin, and lets time pass until the run is over, its time is up or somebody wants it to stop. On the caller's thread. */
    RunOutcome live(FleetRun run, RunObserver observer);

    /** The news of a run as its observer is to hear them. */
    RunObserver.News heard(RunObserver.News news);

    /** The run has ended: finishes what is still under way, and notes where the boats are now. On the caller's thread. */
    void leave(long endMillis);

    /** Waits until the operator's models show all that happened before. On the caller's thread. */
    void awaitShown();

    /** Why the run failed, with what the boats can add to it. */
    default String reason(String fault) {
        return fault;
    }
}
