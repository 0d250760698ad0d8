package org.sami.spn.phase;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The phase chart of a plan (thesis 5.2.3): its marked actions in phases, in rows by actor, in the order in which the net lets them
 * follow one another. Made once from the plan; what a mission has done of it is {@link PhaseProgress}. Immutable.
 */
public final class PhaseChart {
    private final Map<String, PhaseAction> actions = new LinkedHashMap<>();
    private final Map<String, List<String>> options = new LinkedHashMap<>();
    private final Map<String, List<String>> following = new LinkedHashMap<>();
    private final Map<String, Integer> levels = new LinkedHashMap<>();
    private final List<String> first = new ArrayList<>();

    private PhaseChart(Plan plan, Vocabulary vocabulary) {
        VertexGraph graph = new VertexGraph(plan);
        PhaseReader reader = new PhaseReader(plan, graph, vocabulary);
        for (String vertex : graph.nearestFromStart(v -> !reader.on(v).isEmpty())) {
            first.add(reader.on(vertex).get(0));
        }
        for (PhaseAction action : reader.actions().values()) {
            List<String> here = reader.on(action.vertex());
            int next = here.indexOf(action.id()) + 1;
            following.put(
                    action.id(),
                    next < here.size()
                            ? List.of(here.get(next))
                            : graph
                                    .nearestAfter(
                                            action.vertex(), v -> !reader.on(v).isEmpty())
                                    .stream()
                                    .map(v -> reader.on(v).get(0))
                                    .toList());
        }
        reached(reader.actions().keySet())
                .forEach(id -> actions.put(id, reader.actions().get(id)));
        options.putAll(reader.options());
        new Levels(following).of(actions.keySet(), levels);
    }

    /** The chart of a plan; without any action where no event has the markup. */
    public static PhaseChart of(Plan plan, Vocabulary vocabulary) {
        return new PhaseChart(plan, vocabulary);
    }

    /** All actions in the order in which they are reached from the start, those that are never reached at last. */
    private Set<String> reached(Set<String> all) {
        Set<String> order = new LinkedHashSet<>(first);
        Deque<String> open = new ArrayDeque<>(first);
        while (!open.isEmpty()) {
            following.getOrDefault(open.remove(), List.of()).stream()
                    .filter(order::add)
                    .forEach(open::add);
        }
        order.addAll(all);
        return order;
    }

    /** Whether the plan has no phases. */
    public boolean isEmpty() {
        return actions.isEmpty();
    }

    /** The names of the phases, in the order in which they are reached. */
    public List<String> phases() {
        return actions.values().stream().map(PhaseAction::phase).distinct().toList();
    }

    /** All actions, in the order in which they are reached. */
    public List<PhaseAction> actions() {
        return List.copyOf(actions.values());
    }

    /** The action of an event, by the event's id in the plan. */
    public Optional<PhaseAction> action(String id) {
        return Optional.ofNullable(actions.get(id));
    }

    /** The branch buttons on an action, in the plan's order. */
    public List<PhaseAction> options(String id) {
        return options.getOrDefault(id, List.of()).stream().map(actions::get).toList();
    }

    /** The branches before which there is no action, so that nothing leads to them. */
    public List<PhaseAction> branchesOfNothing() {
        Set<String> led = options.values().stream().flatMap(List::stream).collect(Collectors.toSet());
        return actions.values().stream()
                .filter(action -> action.branch() && !led.contains(action.id()))
                .toList();
    }

    /**
     * A phase with the effects of certain choices. At a branch where nothing is chosen the first option is shown.
     *
     * @param chosen the id of the chosen option, by the id of the action that has it
     * @throws IllegalArgumentException if there is no such phase
     */
    public PhaseView view(String phase, Map<String, String> chosen) {
        if (!phases().contains(phase)) {
            throw new IllegalArgumentException("There is no phase '" + phase + "' but " + phases());
        }
        Set<String> next = new LinkedHashSet<>();
        List<PhaseAction> shown = shown(phase, chosen, next).stream()
                .map(actions::get)
                .sorted(Comparator.comparingInt(action -> levels.get(action.id())))
                .toList();
        List<String> actors = shown.stream().map(PhaseAction::actor).distinct().toList();
        List<Integer> columns =
                shown.stream().map(action -> levels.get(action.id())).distinct().toList();
        List<PhaseView.Box> boxes = shown.stream()
                .map(action -> new PhaseView.Box(
                        action,
                        actors.indexOf(action.actor()),
                        columns.indexOf(levels.get(action.id())),
                        options(action.id()),
                        choice(action.id(), chosen).orElse("")))
                .toList();
        return new PhaseView(phase, actors, boxes, List.copyOf(next));
    }

    private Optional<String> choice(String action, Map<String, String> chosen) {
        List<String> all = options.getOrDefault(action, List.of());
        String wanted = chosen.getOrDefault(action, "");
        return all.contains(wanted) ? Optional.of(wanted) : all.stream().findFirst();
    }

    /** The actions of a phase that its entries lead to; gathers the phases that they lead to. */
    private Set<String> shown(String phase, Map<String, String> chosen, Set<String> next) {
        Set<String> shown = new LinkedHashSet<>(entries(phase));
        Deque<String> open = new ArrayDeque<>(shown);
        while (!open.isEmpty()) {
            String action = open.remove();
            Optional<String> choice = choice(action, chosen);
            for (String follower : following.getOrDefault(action, List.of())) {
                boolean otherOption = options.getOrDefault(action, List.of()).contains(follower)
                        && !choice.equals(Optional.of(follower));
                if (otherOption) {
                    continue;
                }
                String follows =
                        Objects.requireNonNull(actions.get(follower), follower).phase();
                if (!follows.equals(phase)) {
                    next.add(follows);
                } else if (shown.add(follower)) {
                    open.add(follower);
                }
            }
        }
        return shown;
    }

    /** The actions with which a phase begins: those reached from the start, from another phase, or from nowhere. */
    private Set<String> entries(String phase) {
        Set<String> inside = actions.values().stream()
                .filter(action -> action.phase().equals(phase))
                .map(PhaseAction::id)
                .collect(Collectors.toCollection(LinkedHashSet::new));
        Set<String> fromInside = new LinkedHashSet<>();
        Set<String> fromOutside = new LinkedHashSet<>(first);
        following.forEach((from, followers) -> (inside.contains(from) ? fromInside : fromOutside).addAll(followers));
        Set<String> entries = new LinkedHashSet<>(inside);
        entries.removeIf(id -> fromInside.contains(id) && !fromOutside.contains(id));
        return entries;
    }
}
