package org.sami.dreamm.tryout;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.Plan;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.protocol.Effect;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;
import org.sami.spn.stepping.Turns;

/** One run of a plan: its stepper, the steps that were taken, and what the last of them did. The plan is the one that it began with. */
final class PlanRun {
    private final String plan;
    private final Stepper stepper;
    private final List<TryOutLine> lines = new ArrayList<>();
    private final Map<Long, Plan> plans = new HashMap<>();
    private List<Effect> lastEffects;
    private boolean outdated;

    /** A run that has begun and taken no step. */
    PlanRun(String plan, Stepper stepper) {
        this.plan = plan;
        this.stepper = stepper;
        lastEffects = stepper.startEffects();
        notePlans();
    }

    String plan() {
        return plan;
    }

    Stepper stepper() {
        return stepper;
    }

    /** The steps that were taken, in order. */
    List<TryOutLine> lines() {
        return List.copyOf(lines);
    }

    int steps() {
        return lines.size();
    }

    /** What the last step, or the start, did; nothing after steps were taken back. */
    List<Effect> lastEffects() {
        return lastEffects;
    }

    /** Notes that the plan has changed since the run began. */
    void setOutdated() {
        outdated = true;
    }

    boolean isOutdated() {
        return outdated;
    }

    /** Notes a step that the stepper has taken, and returns its line. */
    TryOutLine add(String words, TakenStep taken) {
        lastEffects = taken.effects();
        notePlans();
        TryOutLine line = new TryOutLine(taken.number(), words, StepWords.of(taken.effects(), this::name));
        lines.add(line);
        return line;
    }

    /** The engine forgets the plans of missions that are over; their last firings are still shown by name. */
    private void notePlans() {
        stepper.view()
                .missions()
                .forEach(mission -> stepper.view().planOf(mission.id()).ifPresent(of -> plans.put(mission.id(), of)));
    }

    private String name(Effect.Fired fired) {
        return Optional.ofNullable(plans.get(fired.mission()))
                .flatMap(of -> new ElementNames(of, stepper.view().vocabulary()).of(fired.transition()))
                .orElse(fired.transition());
    }

    /** Takes so many steps back, or all where there are fewer; returns how many. */
    int back(int steps) {
        int count = Math.min(steps, lines.size());
        stepper.back(count);
        lines.subList(lines.size() - count, lines.size()).clear();
        lastEffects = List.of();
        return count;
    }

    /**
     * Who acts next where the run goes on by itself.
     *
     * @param locations how many the operator gives where some are asked for
     */
    Turns turns(int locations, boolean operator, boolean robots) {
        return Turns.of(stepper, List.of(locations), operator, robots);
    }

    /** The first of some breakpoints that the last step entered or fired. */
    Optional<Breakpoint> met(Set<Breakpoint> breakpoints) {
        return lastEffects.stream()
                .map(this::vertex)
                .flatMap(Optional::stream)
                .filter(breakpoints::contains)
                .findFirst();
    }

    private Optional<Breakpoint> vertex(Effect effect) {
        if (effect instanceof Effect.Entered entered) {
            return planOf(entered.mission()).map(id -> new Breakpoint(id, entered.place()));
        }
        return effect instanceof Effect.Fired fired
                ? planOf(fired.mission()).map(id -> new Breakpoint(id, fired.transition()))
                : Optional.empty();
    }

    private Optional<String> planOf(long mission) {
        return mission == stepper.mission()
                ? Optional.of(plan)
                : stepper.view().mission(mission).map(MissionView::plan);
    }

    /** The newest mission of a plan in the run; empty where none runs. */
    Optional<MissionView> mission(String planId) {
        return stepper.view().missions().stream()
                .filter(mission -> mission.plan().equals(planId))
                .reduce((older, newer) -> newer);
    }
}
