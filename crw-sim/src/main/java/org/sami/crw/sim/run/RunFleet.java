package org.sami.crw.sim.run;

import java.util.List;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.decision.DefaultAnswers;
import org.sami.crw.report.LinkResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.sim.run.record.BoatState;
import org.sami.crw.sim.run.record.ReportFolds;

/**
 * The boats of one run and the way their time passes: simulated boats in this process on a virtual clock, or other processes over TCP in real time.
 * {@link RunHarness} has all that both have in common. For the engine's thread, unless stated otherwise.
 */
public interface RunFleet {
    /** The plane in metres around the area's centre. */
    LocalFrame plane();

    /** The simulated operator's answers where no rule gives one. */
    DefaultAnswers operatorDefaults();

    /** The boats that interrupts may name; an interrupt counts them in this order. */
    List<String> names();

    /** Their present state: the true one of simulated boats, the last reported one of others. */
    List<BoatState> boats();

    /** The history of a boat's link. */
    LinkResult link(String boat);

    /** Adds the parts of the report that only this kind of fleet has. */
    default void addTo(ReportFolds report) {}

    /** Checks which locations boats have reached; called several times a second. */
    void lookForVisits(long nowMillis);

    /** Records the boats' positions; called once a second. */
    void track(long nowMillis);

    /** Starts the harness and lets time pass until the run is over, its time is up or the observer stops it. On the caller's thread. */
    RunOutcome live(FleetRun run, RunObserver observer);

    /** The news of a run in the form in which its observer gets them. */
    RunObserver.News heard(RunObserver.News news);

    /** Finishes pending work of a run that has ended, and records where the boats are. On the caller's thread. */
    void leave(long endMillis);

    /** Waits until the operator's models show everything so far. On the caller's thread. */
    void awaitShown();

    /** The reason of a failure, with what the boats add to it. */
    default String reason(String fault) {
        return fault;
    }
}
