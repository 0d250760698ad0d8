package org.sami.crw.sim.run.record;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.sami.crw.operator.ClickCount;
import org.sami.crw.report.statistics.MissionFigures;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Counts what each mission of a session needed: time, questions, clicks, presses, boats. A press counts for each mission in which a transition fired with it,
 * and its clicks for the first of them. Used by one thread.
 */
public final class MissionFiguresFold implements HostListener {
    private final Vocabulary vocabulary;
    private final Odometers odometers;
    private final Map<Long, Kept> missions = new LinkedHashMap<>();
    private final Map<Long, Asked> open = new HashMap<>();
    private final ClickCount clicks = new ClickCount();
    private int decisions;

    /** A question that is open. */
    private record Asked(long mission, long atMillis) {}

    /** What is known of a mission. */
    private static final class Kept {
        private final String plan;
        private final boolean isRoot;
        private final long startMillis;
        private Optional<Long> endMillis = Optional.empty();
        private final SortedMap<String, Integer> presses = new TreeMap<>();
        private final SortedSet<String> boats = new TreeSet<>();
        private int decisions;
        private int answered;
        private long answerMillis;
        private long clicks;

        Kept(String plan, boolean isRoot, long startMillis) {
            this.plan = plan;
            this.isRoot = isRoot;
            this.startMillis = startMillis;
        }
    }

    /**
     * Counts nothing yet.
     *
     * @param vocabulary of the session
     * @param odometers how far the boats of the session drove
     */
    public MissionFiguresFold(Vocabulary vocabulary, Odometers odometers) {
        this.vocabulary = vocabulary;
        this.odometers = odometers;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        long clicked = clicks.clicks();
        clicks.count(input, effects);
        Optional<Asked> answered = input instanceof Input.AnswerDecision answer
                ? Optional.ofNullable(open.get(answer.decision()))
                : input instanceof Input.HoldDecision hold
                        ? Optional.ofNullable(open.get(hold.decision()))
                        : Optional.empty();
        Set<String> pressed = new HashSet<>(); // mission and interrupt: a press counts once in each
        long owner = Ids.NONE;
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted started) {
                boolean isRoot = started.parent() == Ids.NONE;
                missions.put(started.mission(), new Kept(started.plan(), isRoot, atMillis));
                owner = owner == Ids.NONE && input instanceof Input.StartMission ? started.mission() : owner;
            } else if (effect instanceof Effect.MissionEnded ended) {
                mission(ended.mission()).ifPresent(kept -> kept.endMillis = Optional.of(atMillis));
            } else if (effect instanceof Effect.Entered entered) {
                mission(entered.mission()).ifPresent(kept -> boats(entered.tokens(), kept.boats));
            } else if (effect instanceof Effect.Fired fired) {
                boolean isPressed = presses(fired, pressed);
                owner = owner == Ids.NONE && isPressed && input instanceof Input.Interrupt ? fired.mission() : owner;
            } else {
                decision(effect, atMillis);
            }
        }
        long of = owner != Ids.NONE ? owner : answered.map(Asked::mission).orElse(named(input));
        mission(of).ifPresent(kept -> kept.clicks += clicks.clicks() - clicked);
    }

    private void decision(Effect effect, long atMillis) {
        if (effect instanceof Effect.DecisionOpened opened) {
            open.put(opened.decision().id(), new Asked(opened.decision().mission(), atMillis));
            decisions++;
            mission(opened.decision().mission()).ifPresent(kept -> kept.decisions++);
        } else if (effect instanceof Effect.DecisionClosed closed) {
            Optional<Asked> asked = Optional.ofNullable(open.remove(closed.decision()));
            if (closed.by().equals(Optional.of(Answerer.OPERATOR)) && asked.isPresent()) {
                mission(asked.get().mission()).ifPresent(kept -> {
                    kept.answered++;
                    kept.answerMillis += atMillis - asked.get().atMillis();
                });
            }
        }
    }

    /** Counts the interrupts with which a transition fired; whether there was one. */
    private boolean presses(Effect.Fired fired, Set<String> pressed) {
        boolean any = false;
        for (Occurrence used : fired.used()) {
            boolean isPress = vocabulary
                    .event(used.type())
                    .filter(type -> type.role().isPress())
                    .isPresent();
            if (isPress && used.values().get(Reserved.INTERRUPT_NAME) instanceof TextValue name) {
                any = true;
                if (pressed.add(fired.mission() + " " + name.value())) {
                    mission(fired.mission()).ifPresent(kept -> kept.presses.merge(name.value(), 1, Integer::sum));
                }
            }
        }
        return any;
    }

    private static void boats(List<Token> tokens, Set<String> boats) {
        for (Token token : tokens) {
            if (token instanceof Token.Proxy proxy) {
                boats.add(proxy.proxy());
            }
        }
    }

    private static long named(Input input) {
        if (input instanceof Input.AbortMission abort) {
            return abort.mission();
        }
        if (input instanceof Input.CompleteMission complete) {
            return complete.mission();
        }
        return input instanceof Input.Interrupt press ? press.mission() : Ids.NONE;
    }

    private Optional<Kept> mission(long id) {
        return Optional.ofNullable(missions.get(id));
    }

    /** All clicks so far. */
    public long clicks() {
        return clicks.clicks();
    }

    /** All questions so far. */
    public int decisions() {
        return decisions;
    }

    /**
     * The missions so far, in the order of their starts.
     *
     * @param nowMillis until when those that run have run
     */
    public List<MissionFigures> missions(long nowMillis) {
        return missions.values().stream().map(kept -> figures(kept, nowMillis)).toList();
    }

    private MissionFigures figures(Kept kept, long nowMillis) {
        long end = kept.endMillis.orElse(nowMillis);
        OptionalDouble distance = odometers.areEmpty()
                ? OptionalDouble.empty()
                : OptionalDouble.of(kept.boats.stream()
                        .mapToDouble(boat -> odometers.metres(boat, kept.startMillis, end))
                        .sum());
        return new MissionFigures(
                kept.plan,
                end - kept.startMillis,
                kept.endMillis.isPresent(),
                kept.isRoot,
                kept.presses,
                kept.decisions,
                kept.answered,
                kept.answerMillis,
                kept.clicks,
                kept.boats,
                distance);
    }
}
