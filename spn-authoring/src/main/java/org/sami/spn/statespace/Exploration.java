package org.sami.spn.statespace;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.Engine;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Token;
import org.sami.spn.stepping.MomentKey;
import org.sami.spn.stepping.NextStep;
import org.sami.spn.stepping.NextSteps;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;
import org.sami.spn.stepping.Turns;

/**
 * The states that a plan reaches by the steps of {@link NextSteps}: first those of runs in which all goes as expected, one for each number of
 * locations, then nearest first, until there is none left, a bound is met or somebody stops it; and then, where that is asked, those that follow
 * when a robot is dropped. States that go on alike ({@link AlikeRobots}) are one. A way on which tokens pile up is not followed further. The same request gives the same exploration.
 */
final class Exploration {
    private static final int REPORT_INTERVAL = 64;
    private static final int LONGEST_RUN = 200;
    /** A state in memory needs so many times the bytes of its shortest form: 3 to 5 were measured on the plans of the boats. */
    private static final int BYTES_PER_BYTE = 6;
    /** What part of the bound on states is for those in which a robot was dropped. */
    private static final int PART_FOR_DROPS = 4;
    /** What is kept of a state that was looked at, in bytes. */
    private static final int BYTES_PER_NODE = 2_000;

    private final DeepRequest request;
    private final SearchWatch watch;
    private final List<Integer> locations = new ArrayList<>();
    private final List<Node> nodes = new ArrayList<>();
    private final Map<MomentKey, Node> known = new LinkedHashMap<>();
    private final Map<Node, Integer> sizes = new LinkedHashMap<>();
    private final Map<String, String> texts = new HashMap<>();
    private final Set<String> visited = new LinkedHashSet<>();
    private final Set<String> fired = new LinkedHashSet<>();
    private final Set<String> unlooked = new LinkedHashSet<>();
    private final AlikeRobots alike;
    private final EndsOfRuns ends;
    private final FirstOfMany firsts;
    private final PilesOfTokens piles;
    private final PilesOfTokens pilesAfterDrops;
    private final List<StepObserver> observers;
    private final Deque<Node> open = new ArrayDeque<>();
    private long usedBytes;
    private int looked;
    private boolean complete;
    private int afterDrops;
    private boolean allDrops;
    private final Set<Node> usualRuns = new LinkedHashSet<>();
    private boolean outOfMemory;

    private Exploration(DeepRequest request, SearchWatch watch) {
        this.request = request;
        this.watch = watch;
        locations.addAll(request.locations());
        locations.add(0);
        Plan plan = request.project().plan(request.plan()).orElseThrow();
        alike = new AlikeRobots(request.project(), request.robots());
        PlanRoles roles = new PlanRoles(plan, request.vocabulary());
        ends = new EndsOfRuns(plan, roles);
        firsts = new FirstOfMany(plan, roles);
        piles = new PilesOfTokens(request.project());
        pilesAfterDrops = new PilesOfTokens(request.project());
        observers = List.of(ends, firsts);
    }

    /**
     * Searches.
     *
     * @param drops whether robots are dropped as well
     */
    static Exploration of(DeepRequest request, SearchWatch watch, boolean drops) {
        Exploration exploration = new Exploration(request, watch);
        exploration.run(
                Stepper.start(
                        new Engine(request.vocabulary(), request.project()),
                        request.plan(),
                        request.plan(),
                        request.robots()),
                drops);
        return exploration;
    }

    private void run(Stepper start, boolean drops) {
        Node first = new Node(start.branch(), Optional.empty(), this::shared);
        add(first, alike.key(start));
        saw(start, start.startEffects());
        for (int count : request.locations()) {
            usualRuns.addAll(runOn(first, start, count));
        }
        Deque<Node> onRuns = new ArrayDeque<>(usualRuns);
        while (goesOn(onRuns)) {
            look(onRuns.poll());
        }
        while (goesOn(open)) {
            look(open.poll());
        }
        complete = looked == nodes.size() && piles.all().isEmpty();
        open.forEach(Node::setUnlooked);
        open.clear();
        if (drops) {
            dropAt(complete ? List.copyOf(nodes) : List.copyOf(usualRuns), start);
        }
        watch.looked(looked, nodes.size() - looked - afterDrops);
    }

    private boolean goesOn(Deque<Node> waiting) {
        return !waiting.isEmpty() && looked < request.mostStates() && mayGoOn();
    }

    private boolean mayGoOn() {
        outOfMemory |= usedBytes > request.mostBytes();
        return !outOfMemory && !watch.isCancelled();
    }

    // ---- With a robot that is dropped

    /** Drops each robot, one in a run, and looks on from there, as far as a part of the bound on states. */
    private void dropAt(List<Node> some, Stepper start) {
        int most = Math.max(1, request.mostStates() / PART_FOR_DROPS);
        allDrops = complete;
        for (Node node : some) {
            boolean goesOn = afterDrops < most && mayGoOn();
            if (goesOn && !node.isOver() && !node.isHalted()) {
                Stepper at = node.replayed(start);
                at.view().proxies().forEach(robot -> drop(node, at, robot));
            }
            allDrops &= goesOn;
            while (afterDrops < most && !open.isEmpty() && mayGoOn()) {
                lookAfterDrop(open.poll());
            }
        }
        allDrops &= open.isEmpty();
        open.forEach(Node::setUnlooked);
    }

    private void drop(Node node, Stepper at, String robot) {
        boolean takesPart = at.view()
                .mission(at.mission())
                .filter(mission ->
                        mission.marking().values().stream().anyMatch(tokens -> tokens.contains(new Token.Proxy(robot))))
                .isPresent();
        if (takesPart) {
            Stepper after = at.branch();
            NextStep step = new NextStep(NextStep.Kind.DROP, new TestStep.Drop(robot));
            TakenStep taken = after.take(step.step());
            if (taken.refusal().isEmpty()) {
                reachedAfterDrop(node, step, after, taken.effects());
            }
        }
    }

    private void reachedAfterDrop(Node from, NextStep step, Stepper after, List<Effect> effects) {
        saw(after, effects);
        reached(from, step, after);
    }

    private void lookAfterDrop(Node node) {
        afterDrops++;
        usedBytes -= sizes.remove(node);
        if (pilesAfterDrops.isPile(node)) {
            node.setUnlooked();
        } else {
            node.stepper().ifPresent(at -> {
                for (NextStep step : stepsAt(node, at)) {
                    Stepper after = at.branch();
                    TakenStep taken = after.take(step.step());
                    if (taken.refusal().isEmpty()) {
                        reachedAfterDrop(node, step, after, taken.effects());
                    }
                }
            });
        }
        node.setLooked();
    }

    // ---- Without

    /** Takes a run in which all goes as expected, and returns its states. */
    private List<Node> runOn(Node first, Stepper start, int count) {
        List<Node> run = new ArrayList<>(List.of(first));
        Stepper at = start.fork();
        Node node = first;
        while (run.size() < Math.min(LONGEST_RUN, request.mostStates())
                && at.outcome().isEmpty()
                && !watch.isCancelled()) {
            Optional<NextStep> next = Turns.expected(at, List.of(count));
            if (next.isEmpty()) {
                return run;
            }
            Stepper before = at.branch();
            TakenStep taken = at.take(next.get().step());
            if (taken.refusal().isPresent()) {
                return run;
            }
            node = reached(node, next.get(), before, at, taken.effects());
            run.add(node);
            if (!at.key().equals(node.key())) { // one like it was there already: the run goes on from that
                at = node.replayed(start);
            }
        }
        return run;
    }

    private void look(Node node) {
        if (node.wasLookedAt()) {
            return;
        }
        looked++;
        usedBytes -= sizes.remove(node);
        if (piles.isPile(node)) {
            node.setUnlooked();
        } else {
            node.stepper().ifPresent(at -> expand(node, at));
        }
        node.setLooked();
        if (looked % REPORT_INTERVAL == 0) {
            watch.looked(looked, nodes.size() - looked);
        }
    }

    private void expand(Node node, Stepper at) {
        for (NextStep step : stepsAt(node, at)) {
            Stepper after = at.branch();
            TakenStep taken = after.take(step.step());
            if (taken.refusal().isEmpty()) {
                reached(node, step, at, after, taken.effects());
            }
        }
    }

    private List<NextStep> stepsAt(Node node, Stepper at) {
        NextSteps next = NextSteps.of(at, locations);
        unlooked.addAll(next.unlooked());
        if (!next.unlooked().isEmpty()) {
            node.setUnlooked();
        }
        List<NextStep> steps = new ArrayList<>(next.steps());
        steps.addAll(untilLaterTimers(at));
        return steps;
    }

    /** Time until each timer that runs longer than the next: states count as one where timers only run differently long ({@link AlikeRobots}). */
    private static List<NextStep> untilLaterTimers(Stepper at) {
        return at.view().dueMillis().stream()
                .skip(1)
                .map(due -> new NextStep(NextStep.Kind.TIME, new TestStep.Advance(due - at.nowMillis())))
                .toList();
    }

    private Node reached(Node from, NextStep step, Stepper before, Stepper after, List<Effect> effects) {
        saw(after, effects);
        observers.forEach(observer -> observer.took(from, step, before, after, effects));
        return reached(from, step, after);
    }

    private Node reached(Node from, NextStep step, Stepper after) {
        Node.Edge edge = new Node.Edge(from, step);
        MomentKey key = alike.key(after);
        Node node = known.get(key);
        if (node == null) {
            node = new Node(after.branch(), Optional.of(edge), this::shared);
            add(node, key);
        } else {
            node.reached(edge, after);
        }
        return node;
    }

    private void add(Node node, MomentKey key) {
        known.put(key, node);
        nodes.add(node);
        open.add(node);
        int bytes = node.stepper().isPresent() ? node.key().stateBytes() * BYTES_PER_BYTE : 0;
        sizes.put(node, bytes);
        usedBytes += bytes + BYTES_PER_NODE;
    }

    private String shared(String text) {
        return texts.computeIfAbsent(text, same -> same);
    }

    private void saw(Stepper stepper, List<Effect> effects) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.Entered e && e.mission() == stepper.mission()) {
                visited.add(e.place());
            } else if (effect instanceof Effect.Fired e && e.mission() == stepper.mission()) {
                fired.add(e.transition());
            }
        }
    }

    // ---- What was found

    /** The states, those of expected runs and then those of the shortest runs first. */
    List<Node> nodes() {
        return nodes;
    }

    /** The states that are reached where the operator never gives an empty list. */
    Set<Node> usual() {
        Map<Node, List<Node>> after = new LinkedHashMap<>();
        nodes.forEach(node -> node.before().stream()
                .filter(edge -> edge.step().kind() != NextStep.Kind.EMPTY)
                .forEach(edge -> after.computeIfAbsent(edge.from(), from -> new ArrayList<>())
                        .add(node)));
        Set<Node> usual = new HashSet<>();
        Deque<Node> toDo = new ArrayDeque<>(List.of(nodes.get(0)));
        while (!toDo.isEmpty()) {
            Node node = toDo.pop();
            if (usual.add(node)) {
                toDo.addAll(after.getOrDefault(node, List.of()));
            }
        }
        return usual;
    }

    /** Places of the plan that somebody or nobody entered. */
    Set<String> visited() {
        return visited;
    }

    /** Transitions of the plan that fired. */
    Set<String> fired() {
        return fired;
    }

    /** What could have happened somewhere and was not tried, in sentences. */
    Set<String> unlooked() {
        return unlooked;
    }

    EndsOfRuns ends() {
        return ends;
    }

    FirstOfMany firsts() {
        return firsts;
    }

    PilesOfTokens piles() {
        return piles;
    }

    int looked() {
        return looked;
    }

    /** Whether the search ended as its memory was used up. */
    boolean isOutOfMemory() {
        return outOfMemory;
    }

    /** Whether every state that was reached was looked at: there are no others by these steps. */
    boolean isComplete() {
        return complete;
    }

    /** How many states were looked at in which a robot had been dropped. */
    int afterDrops() {
        return afterDrops;
    }

    /** Whether each robot was dropped at every state, and all that follows was looked at. */
    boolean areAllDropsTried() {
        return allDrops;
    }
}
