package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;

/** A net while it is made: what its parts share. For one thread. */
final class PlanNetWork {
    private final PlanNetRequest request;
    private final Plan plan;
    private final List<PlanToken> team;
    private final RobotView view;
    private final BitSet sure = new BitSet();
    private final PossibleTokens possible;
    private final PetriNetBuilder net;
    private final MissionPlaces places;
    private final int beyond;
    private final List<PlanNetFiring> firings = new ArrayList<>();
    private final List<List<TokenOption>> counted = new ArrayList<>();
    private final Map<String, Integer> ids = new HashMap<>();

    PlanNetWork(PlanNetRequest request, Plan plan, List<PlanToken> team, RobotView view) {
        this.request = request;
        this.plan = plan;
        this.team = team;
        this.view = view;
        possible = new PossibleTokens(request.project(), request.vocabulary(), plan, team);
        net = new PetriNetBuilder(plan.title());
        places = new MissionPlaces(
                net,
                plan,
                team,
                possible,
                view == RobotView.PRESENT ? 1 : request.robots().size());
        beyond = places.control("beyond", "more tokens at once than the net follows", 0);
    }

    Plan plan() {
        return plan;
    }

    Vocabulary vocabulary() {
        return request.vocabulary();
    }

    List<PlanToken> team() {
        return team;
    }

    RobotView view() {
        return view;
    }

    /** The transition that was added last surely can fire where the net says so. */
    void isSure() {
        sure.set(firings.size() - 1);
    }

    /** The transitions that surely can fire where the net says so. */
    BitSet sure() {
        return sure;
    }

    PossibleTokens possible() {
        return possible;
    }

    MissionPlaces places() {
        return places;
    }

    /** The place that is marked where tokens were more than the net follows. */
    int beyond() {
        return beyond;
    }

    List<PlanNetFiring> firings() {
        return firings;
    }

    /** For each transition of the net what becomes of the robots that are counted. */
    List<List<TokenOption>> counted() {
        return counted;
    }

    int robots() {
        return request.robots().size();
    }

    /** How many tokens of the mission one of the team stands for. */
    int count(PlanToken token) {
        return token.equals(PlanToken.ROBOTS) ? robots() : 1;
    }

    /**
     * Adds a transition of the net.
     *
     * @param robots what becomes of the robots that are counted
     */
    void putFiring(String title, PlanNetFiring firing, List<TokenOption> robots, CaseArcs arcs, int number)
            throws PlanNetTooLargeException {
        if (firings.size() >= request.mostTransitions()) {
            throw new PlanNetTooLargeException("with " + request.robots().size() + " robots the net of \""
                    + plan.title()
                    + "\" has more than " + request.mostTransitions() + " transitions; \"" + title + "\" alone has "
                    + number + " cases and more: ask about fewer robots");
        }
        String name = firing.named().isEmpty() ? "" : "(" + String.join(",", firing.named()) + ")";
        String id = (firing.transition().isEmpty() ? "end" : firing.transition()) + name;
        int same = ids.merge(id, 1, Integer::sum);
        int transition = net.transition(same == 1 ? id : id + "~" + same, title + name);
        arcs.put(net, transition);
        firings.add(firing);
        counted.add(robots);
    }

    PetriNet build() {
        return net.build();
    }
}
