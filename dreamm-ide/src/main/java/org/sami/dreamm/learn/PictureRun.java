package org.sami.dreamm.learn;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.picture.net.NetMarking;
import org.sami.spn.engine.Engine;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStep;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.FollowedMarking;
import org.sami.spn.stepping.NextStep;
import org.sami.spn.stepping.NextSteps;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;
import org.sami.spn.value.DurationValue;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.ui.value.ValueSummary;

/**
 * A plan of a lesson that runs on the engine, step by step, forwards and back: the steps of a test case, or what the learner chooses of all that can happen. Used
 * by one thread.
 */
public final class PictureRun {
    private static final int MOST_CHOICES = 8;

    private final Plan plan;
    private final Optional<TestCase> played;
    private final Stepper stepper;
    private final ElementNames names;
    private List<Effect> last;
    private List<Effect> before = List.of(); // what stood where before the last step
    private String message;

    private PictureRun(Plan plan, Optional<TestCase> played, Stepper stepper, Vocabulary vocabulary) {
        this.plan = Objects.requireNonNull(plan, "plan");
        this.played = played;
        this.stepper = stepper;
        names = new ElementNames(plan, vocabulary);
        last = stepper.startEffects();
        message = "At the start";
    }

    /**
     * A run of a test case, at its start.
     *
     * @throws IllegalArgumentException with the reason if the plan cannot start so
     */
    public static PictureRun of(Project project, Vocabulary vocabulary, Plan plan, TestCase test) {
        Stepper stepper = Stepper.startAs(new Engine(vocabulary, project), plan.id(), test.withSteps(List.of()));
        return new PictureRun(plan, Optional.of(test), stepper, vocabulary);
    }

    /**
     * A run in which the learner chooses what happens, at its start.
     *
     * @throws IllegalArgumentException with the reason if the plan cannot start so
     */
    public static PictureRun free(Project project, Vocabulary vocabulary, Plan plan, List<String> robots) {
        TestCase test = new TestCase("free", robots, List.of());
        return new PictureRun(
                plan, Optional.empty(), Stepper.startAs(new Engine(vocabulary, project), plan.id(), test), vocabulary);
    }

    /** The plan that runs. */
    public Plan plan() {
        return plan;
    }

    /** How many steps were taken. */
    public int steps() {
        return stepper.steps().size();
    }

    /** How many steps there are; empty where the learner chooses them. */
    public Optional<Integer> all() {
        return played.map(test -> test.steps().size());
    }

    /** What the next step is, in words; empty where the learner chooses, or none is left. */
    public Optional<String> next() {
        return played.filter(test -> steps() < test.steps().size())
                .map(test -> words(test.steps().get(steps())));
    }

    /** What can happen now, in words, the expected first; nothing where a test case is played, and after the end. */
    public List<String> choices() {
        return possible().stream().map(step -> words(step.step())).toList();
    }

    private List<NextStep> possible() {
        return played.isPresent() || isOver()
                ? List.of()
                : NextSteps.of(stepper, NextSteps.LOCATIONS).steps().stream()
                        .limit(MOST_CHOICES)
                        .toList();
    }

    /** Takes the next step of the test case; nothing happens where none is left. */
    public void forward() {
        played.filter(test -> steps() < test.steps().size())
                .ifPresent(test -> take(test.steps().get(steps())));
    }

    /** Takes one of the {@link #choices}. */
    public void choose(int index) {
        List<NextStep> possible = possible();
        if (index >= 0 && index < possible.size()) {
            take(possible.get(index).step());
        }
    }

    private void take(TestStep step) {
        String words = words(step);
        before = standing();
        TakenStep taken = stepper.take(step);
        last = taken.effects();
        message = taken.refusal().map(why -> words + ": " + why).orElseGet(() -> words + came());
    }

    private String came() {
        List<String> fired = new ArrayList<>();
        for (String transition : fired()) {
            fired.add(names.of(transition).orElse(transition));
        }
        String firings = fired.isEmpty() ? "; no transition fires" : "; fires: " + String.join(", ", fired);
        return firings + (isOver() ? "; the mission has ended" : "");
    }

    /** Takes the last step back. */
    public void back() {
        if (steps() > 0) {
            stepper.back(1);
            last = List.of();
            message = steps() == 0 ? "At the start" : "Back behind step " + steps();
        }
    }

    /** Takes all steps back. */
    public void restart() {
        stepper.back(steps());
        last = stepper.startEffects();
        message = "At the start";
    }

    /** Whether the mission has ended. */
    public boolean isOver() {
        return stepper.outcome().isPresent();
    }

    /** Whether a step can be taken that the test case says. */
    public boolean hasNext() {
        return next().isPresent();
    }

    /** What happened last, in a sentence. */
    public String message() {
        return message;
    }

    private List<Effect> standing() {
        List<Effect> effects = new ArrayList<>();
        stepper.view().markingAsEffects().forEach(effects::add);
        return effects;
    }

    /** Where tokens stand; once the mission has ended, where they stood when it did: the engine knows them no longer then. */
    public NetMarking marking() {
        FollowedMarking followed = new FollowedMarking();
        if (!isOver()) {
            standing().forEach(followed);
            return shown(followed);
        }
        before.forEach(followed);
        for (Effect effect : last) {
            if (effect instanceof Effect.MissionEnded ended && ended.mission() == stepper.mission()) {
                break;
            }
            followed.accept(effect);
        }
        return shown(followed);
    }

    private NetMarking shown(FollowedMarking followed) {
        return NetMarking.of(followed, stepper.mission(), stepper.view().allocation());
    }

    /** The transitions of the plan that the last step fired. */
    public Set<String> fired() {
        Set<String> fired = new LinkedHashSet<>();
        for (Effect effect : last) {
            if (effect instanceof Effect.Fired firing && firing.mission() == stepper.mission()) {
                fired.add(firing.transition());
            }
        }
        return fired;
    }

    private String words(TestStep step) {
        return step instanceof TestStep.Advance advance
                ? ValueSummary.of(new DurationValue(advance.millis())) + " pass"
                : stepper.words().of(step);
    }
}
