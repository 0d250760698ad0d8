package org.sami.spn.planspace;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.plannet.PlanMarking;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetFiring;
import org.sami.spn.plannet.PlanNetMove;

/** The words for states and firings of a plan's net: its places and transitions by their names, robots by theirs. */
public final class PlanStateWords implements StateWords {
    private final PlanNet net;
    private final Plan plan;

    public PlanStateWords(PlanNet net) {
        this.net = net;
        plan = net.request().project().plan(net.request().plan()).orElseThrow();
    }

    @Override
    public List<String> marked(int[] marking) {
        return marked(net.marking(marking));
    }

    /** The marked places, each with its tokens: {@code Execute: robot-1 robot-2}. */
    public List<String> marked(PlanMarking marking) {
        List<String> marked = new ArrayList<>();
        marking.tokens().forEach((place, tokens) -> marked.add(place(place) + ": " + tokens(tokens)));
        marking.nobody().stream()
                .filter(place -> !marking.tokens().containsKey(place))
                .forEach(place -> marked.add(place(place) + ": nobody"));
        return marked;
    }

    private static String tokens(SortedMap<String, Integer> tokens) {
        List<String> words = new ArrayList<>();
        tokens.forEach((token, count) -> words.add(count == 1 ? token : count + " " + token));
        return String.join(" ", words);
    }

    /** A place by its name, or by its id where the author gave it none; behind the place whose sub-mission has it. */
    public String place(String id) {
        return SubMissionPath.words(
                net.request().project(), plan, id, (of, last) -> of.place(last).map(Place::name));
    }

    /** A transition by its name, or by its id where the author gave it none; behind the place whose sub-mission has it. */
    public String transition(String id) {
        return SubMissionPath.words(
                net.request().project(),
                plan,
                id,
                (of, last) -> of.transition(last).map(Transition::name));
    }

    @Override
    public String firing(int transition) {
        return firing(net.firing(transition));
    }

    /** A firing: its transition, and whom the input events name. */
    String firing(PlanNetFiring firing) {
        if (firing.transition().isEmpty()) {
            return "the mission ends";
        }
        String name = transition(firing.transition());
        return firing.named().isEmpty() ? name : name + " (" + String.join(", ", firing.named()) + ")";
    }

    /** A firing with what it does with tokens: {@code Arrived (robot-1): robot-1 Execute → Finished}. */
    public String moves(PlanNetFiring firing) {
        Map<String, List<String>> tokens = new LinkedHashMap<>();
        for (PlanNetMove move : firing.moves()) {
            String way = (move.from().isEmpty() ? "" : " " + place(move.from())) + " → "
                    + (move.to().isEmpty() ? "consumed" : place(move.to()));
            tokens.computeIfAbsent(way, w -> new ArrayList<>()).add(move.token());
        }
        List<String> moves = new ArrayList<>();
        tokens.forEach((way, who) -> moves.add(String.join(" ", who) + way));
        return firing(firing) + (moves.isEmpty() ? "" : ": " + String.join(", ", moves));
    }

    @Override
    public boolean isEnd(int[] marking) {
        return !net.marking(marking).running();
    }
}
