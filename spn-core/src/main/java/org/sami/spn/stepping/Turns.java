package org.sami.spn.stepping;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Token;
import org.sami.spn.stepping.NextStep.Kind;

/**
 * Who acts next where a plan is run on by itself. Operator, robots and services take turns: of what leads to a moment that was not there
 * yet, the one that acted least goes first, and an answer that was given many times comes after the others. Time passes where nobody else leads
 * on. Where all that is expected leads back only, the run goes round; then the nearest end is looked for among everything that could happen,
 * and the step towards it that leads out is taken and reported. Used by one thread at a time, which need not be the stepper's.
 */
public final class Turns {
    /** An answer that was given so often comes after the others. */
    private static final int REPEAT_LIMIT = 8;
    /** After so many moments with one summary, another with it counts as reached before: only the order of tokens differs. */
    private static final int MOST_ALIKE = 3;
    /** After so many steps in which nobody came to where he was not yet, the run goes round. */
    private static final int MOST_STEPS_WITHOUT_NEWS = 40;
    /** How many steps are tried for a way that leads on: less than 30 ms of processor time, measured on every plan of the library with 3 robots. */
    private static final int MOST_TRIED = 600;

    private static final Set<Kind> EXPECTED = Set.of(Kind.DECISION, Kind.ANSWER, Kind.TIME);

    private final Stepper stepper;
    private final List<Integer> locations;
    private final Predicate<Kind> isPlayed;
    private final Set<MomentKey> before;
    private int tried;
    private boolean round;
    private BooleanSupplier cancelled = () -> false;
    private final Map<String, Integer> summaries = new HashMap<>();
    private final int stepsWithoutNews;
    private final Map<String, Integer> turns = new HashMap<>();
    private final Map<TestStep, Integer> uses = new HashMap<>();

    /**
     * What is done next.
     *
     * @param step the step to take; empty where nothing leads on
     * @param remark why it is taken, or why none is, where that is out of the ordinary: the run goes round; else empty text
     */
    public record Turn(Optional<NextStep> step, String remark) {
        public Turn {
            Objects.requireNonNull(step, "step");
            Objects.requireNonNull(remark, "remark");
        }
    }

    private record Candidate(NextStep step, boolean leadsOn) {}

    private record Way(Stepper at, List<NextStep> steps) {}

    private Turns(Stepper stepper, List<Integer> locations, Predicate<Kind> isPlayed) {
        this.stepper = stepper.apart();
        this.locations = locations;
        this.isPlayed = isPlayed;
        before = new HashSet<>(stepper.keysBefore());
        before.add(stepper.key());
        stepper.summariesBefore().forEach(summary -> summaries.merge(summary, 1, Integer::sum));
        summaries.merge(stepper.summary(), 1, Integer::sum);
        stepsWithoutNews = stepsWithoutNews(stepper);
        for (TestStep taken : stepper.said()) {
            turns.merge(actor(taken), 1, Integer::sum);
            uses.merge(taken, 1, Integer::sum);
        }
    }

    /** How many steps ago somebody last came to where he was not yet. */
    private static int stepsWithoutNews(Stepper stepper) {
        Set<String> been = new HashSet<>();
        int without = 0;
        for (TakenStep step : stepper.steps()) {
            boolean news = false;
            for (Effect effect : step.effects()) {
                if (effect instanceof Effect.Entered entered) {
                    for (Token token : entered.tokens()) {
                        news |= been.add(entered.place() + " " + token);
                    }
                    news |= been.add(entered.place());
                }
            }
            without = news ? 0 : without + 1;
        }
        return without;
    }

    /**
     * The next step of a run.
     *
     * @param locations as for {@link NextSteps#of}
     * @param isOperator whether the operator acts by himself
     * @param isRobots whether robots and services do
     */
    public static Turn next(Stepper stepper, List<Integer> locations, boolean isOperator, boolean isRobots) {
        Turns turns = of(stepper, locations, isOperator, isRobots);
        return turns.expected().orElseGet(() -> turns.leadOut(() -> false));
    }

    /**
     * The turns at the present moment of a run; what the stepper does later they do not see.
     *
     * @param locations as for {@link NextSteps#of}
     * @param isOperator whether the operator acts by himself
     * @param isRobots whether robots and services do
     */
    public static Turns of(Stepper stepper, List<Integer> locations, boolean isOperator, boolean isRobots) {
        return new Turns(stepper, locations, kind -> switch (kind) {
            case DECISION, INTERRUPT -> isOperator;
            case ANSWER, FAILURE, NEWS -> isRobots;
            case TIME -> true;
            case EMPTY, DROP -> false;
        });
    }

    /**
     * The next step of a run in which all goes as expected; empty where nothing expected leads on.
     *
     * @param locations as for {@link NextSteps#of}
     */
    public static Optional<NextStep> expected(Stepper stepper, List<Integer> locations) {
        Turns turns = new Turns(stepper, locations, EXPECTED::contains);
        return turns.fresh(turns.candidates(stepper, EXPECTED::contains));
    }

    /** The expected step that leads on, found in a few milliseconds; empty where none does. */
    public Optional<Turn> expected() {
        List<Candidate> candidates = candidates(stepper, kind -> EXPECTED.contains(kind) && isPlayed.test(kind));
        round = !candidates.isEmpty();
        Optional<NextStep> fresh = fresh(candidates);
        return fresh.isPresent() ? Optional.of(new Turn(fresh, "")) : Optional.empty();
    }

    private Optional<NextStep> fresh(List<Candidate> candidates) {
        return candidates.stream()
                .filter(candidate -> candidate.leadsOn() && stepsWithoutNews < MOST_STEPS_WITHOUT_NEWS)
                .map(Candidate::step)
                .min(Comparator.comparing((NextStep step) -> uses.getOrDefault(step.step(), 0) >= REPEAT_LIMIT)
                        .thenComparing(step -> step.kind() == Kind.TIME)
                        .thenComparing(step -> turns.getOrDefault(actor(step.step()), 0)));
    }

    /** The steps of some kinds that change something, or let time pass, with what they lead to. */
    private List<Candidate> candidates(Stepper at, Predicate<Kind> wanted) {
        List<Candidate> candidates = new ArrayList<>();
        for (NextStep step : NextSteps.of(at, locations).steps()) {
            if (wanted.test(step.kind())) {
                Stepper tried = at.branch();
                boolean taken = tried.take(step.step()).refusal().isEmpty();
                if (taken && (step.kind() == Kind.TIME || !tried.key().equals(at.key()))) {
                    candidates.add(new Candidate(step, leadsOn(tried)));
                }
            }
        }
        return candidates;
    }

    /** Whether a moment was not there yet. */
    private boolean leadsOn(Stepper tried) {
        return !before.contains(tried.key()) && summaries.getOrDefault(tried.summary(), 0) < MOST_ALIKE;
    }

    /** The actor of a step: a robot or a task, the operator at one question, the answerer of one event, time. */
    private static String actor(TestStep step) {
        if (step instanceof TestStep.Answer answer) {
            return "operator " + answer.event();
        } else if (step instanceof TestStep.Occur occur) {
            return occur.proxies().isEmpty() && occur.tasks().isEmpty()
                    ? occur.type() + " " + occur.answers()
                    : occur.proxies() + " " + occur.tasks();
        }
        return step.getClass().getSimpleName();
    }

    // ---- Where nothing expected leads on

    /**
     * The nearest way to an end, else to a moment that was not there yet: expected steps first, then whatever else could happen. To be asked
     * after {@link #expected}, where that found nothing; takes some tenths of a second. May be asked on another thread, by one at a time.
     *
     * @param isCancelled asked before each step that is tried; where it says so, no step is found
     */
    public Turn leadOut(BooleanSupplier isCancelled) {
        cancelled = isCancelled;
        Predicate<Kind> expected = kind -> EXPECTED.contains(kind) && isPlayed.test(kind);
        Optional<Way> way = way(expected, true)
                .or(() -> way(isPlayed, true))
                .or(() -> stepsWithoutNews < MOST_STEPS_WITHOUT_NEWS ? way(expected, false) : Optional.empty())
                .or(() -> way(isPlayed, false));
        if (way.isPresent()) {
            NextStep first = way.get().steps().get(0);
            return new Turn(Optional.of(first), remark(round, way.get()));
        }
        Optional<Way> byHand = way(kind -> kind != Kind.EMPTY, false);
        if (cancelled.getAsBoolean()) {
            return new Turn(Optional.empty(), "The look for what leads on was stopped");
        }
        return new Turn(
                Optional.empty(),
                byHand.map(found -> stopped(round, words(found)))
                        .orElse(
                                round
                                        ? "This goes round, and nothing that can be tried leads out"
                                        : "Nothing goes on by itself, and nothing that can be tried leads on"));
    }

    private static String stopped(boolean round, String what) {
        return round
                ? "This goes round; what leads out, by hand: " + what
                : "Nothing goes on by itself; what leads on, by hand: " + what;
    }

    private String remark(boolean round, Way way) {
        return way.steps().stream().allMatch(step -> EXPECTED.contains(step.kind()))
                ? ""
                : (round ? "it went round; " : "nothing went on by itself; ") + words(way) + " leads out";
    }

    /** The steps of a way that nobody expects; where all are expected, the first. */
    private String words(Way way) {
        StepText text = stepper.words();
        List<String> unexpected = way.steps().stream()
                .filter(step -> !EXPECTED.contains(step.kind()))
                .map(step -> text.of(step.step()))
                .distinct()
                .toList();
        return unexpected.isEmpty() ? text.of(way.steps().get(0).step()) : String.join(", then ", unexpected);
    }

    /** The shortest way of such steps to an end; else, unless only an end is requested, to a moment that was not there yet. */
    private Optional<Way> way(Predicate<Kind> wanted, boolean onlyToEnd) {
        Set<MomentKey> known = new HashSet<>();
        known.add(stepper.key());
        Deque<Way> open = new ArrayDeque<>(List.of(new Way(stepper.branch(), List.of())));
        Optional<Way> fresh = Optional.empty();
        int until = tried + MOST_TRIED / 4;
        while (!open.isEmpty() && tried < until && !cancelled.getAsBoolean()) {
            Way way = open.poll();
            for (NextStep step : NextSteps.of(way.at(), locations).steps()) {
                if (!wanted.test(step.kind())) {
                    continue;
                }
                tried++;
                Stepper behind = way.at().branch();
                if (behind.take(step.step()).refusal().isPresent() || !known.add(behind.key())) {
                    continue;
                }
                List<NextStep> steps = new ArrayList<>(way.steps());
                steps.add(step);
                Way longer = new Way(behind, steps);
                if (behind.outcome().isPresent()) {
                    return Optional.of(longer);
                }
                if (fresh.isEmpty() && !onlyToEnd && leadsOn(behind)) {
                    fresh = Optional.of(longer);
                }
                open.add(longer);
            }
        }
        return fresh;
    }
}
