package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.Vocabulary;

/** A net while it is made: what its parts share. For one thread. */
final class PlanNetWork implements ChildMission {
    private final PlanNetRequest request;
    private final Plan plan;
    private final List<PlanToken> team;
    private final RobotView view;
    private final Optional<PlanNetWork> parent;
    private final String path;
    private final boolean isShared;
    private final BitSet sure = new BitSet();
    private final PossibleTokens possible;
    private final PetriNetBuilder net;
    private final MissionPlaces places;
    private final int beyond;
    private final List<PlanNetFiring> firings;
    private final List<List<TokenOption>> counted;
    private final Map<String, Integer> ids;
    private final Map<FollowedChild, PlanNetWork> children = new LinkedHashMap<>();

    PlanNetWork(PlanNetRequest request, Plan plan, List<PlanToken> team, RobotView view) {
        this.request = request;
        this.plan = plan;
        this.team = team;
        this.view = view;
        parent = Optional.empty();
        path = "";
        isShared = false;
        firings = new ArrayList<>();
        counted = new ArrayList<>();
        ids = new HashMap<>();
        possible = new PossibleTokens(
                request.project(), request.vocabulary(), plan, team, request.depth() > 0 && view == RobotView.NAMED);
        net = new PetriNetBuilder(plan.title());
        places = new MissionPlaces(
                net,
                plan,
                team,
                possible,
                view == RobotView.PRESENT ? 1 : request.robots().size());
        beyond = places.control("beyond", "more tokens at once than the net follows", 0);
    }

    /**
     * A sub-mission in the net of its parent.
     *
     * @param at the parent's place
     */
    PlanNetWork(PlanNetWork parent, Place at, Plan plan) {
        request = parent.request;
        this.plan = plan;
        team = parent.team;
        view = parent.view;
        this.parent = Optional.of(parent);
        path = parent.path(at.id()) + "/";
        isShared = at.subMissions().get(0).shared();
        firings = parent.firings;
        counted = parent.counted;
        ids = parent.ids;
        possible = parent.possibleIn(at, plan);
        net = parent.net;
        boolean runs = isShared ? parent.places.runsAtFirst() : parent.places.startsWith(at.id());
        places = new MissionPlaces(
                parent.places,
                path,
                plan,
                team,
                possible,
                (place, token) -> place.start() ? parent.places.initialIn(at.id(), token) : 0,
                runs);
        beyond = parent.beyond;
    }

    /** Which tokens can come to which place of a plan that runs as a sub-mission of a place. */
    PossibleTokens possibleIn(Place at, Plan child) {
        return new PossibleTokens(
                request.project(),
                request.vocabulary(),
                child,
                team,
                token -> possible.comes(at.id(), token),
                token -> possible.isLoose(token, at.id()),
                true);
    }

    @Override
    public Plan plan() {
        return plan;
    }

    /** Whether entering an end place ends the mission: in a shared sub-mission others only return who enters (R-SHR-1, R-SHR-2). */
    boolean endsMission(Place end) {
        return end.end() && (!isShared || end.endsSharedInstance());
    }

    Project project() {
        return request.project();
    }

    /** Of a sub-mission: the mission that runs it. */
    Optional<PlanNetWork> parent() {
        return parent;
    }

    /** A place or transition of the plan, behind the path to the sub-mission that has it. */
    String path(String id) {
        return path + id;
    }

    /** Follows a sub-mission. */
    void follow(FollowedChild child, PlanNetWork mission) {
        children.put(child, mission);
    }

    /** The sub-missions that are followed. */
    @Override
    public List<FollowedChild> children() {
        return List.copyOf(children.keySet());
    }

    /** Their missions. */
    List<PlanNetWork> missions() {
        return List.copyOf(children.values());
    }

    /** The sub-mission that is followed on a place. */
    @Override
    public Optional<FollowedChild> child(String place) {
        return children.keySet().stream()
                .filter(child -> child.place().equals(place))
                .findFirst();
    }

    /** Whether a return can bring a token to a place with a sub-mission: one that is shared and followed brings only what comes to its end places. */
    boolean mayReturn(String place, PlanToken token) {
        return child(place).filter(child -> !child.mayReturn(token)).isEmpty();
    }

    /** The one that a sub-mission is for its parent. */
    Optional<FollowedChild> asChild() {
        return parent.stream()
                .flatMap(of -> of.children.entrySet().stream())
                .filter(child -> child.getValue() == this)
                .map(Map.Entry::getKey)
                .findFirst();
    }

    /** The places of the net that are marked while a sub-mission is not followed, by the path of its place. */
    Map<String, Integer> open() {
        Map<String, Integer> open = new LinkedHashMap<>();
        for (Map.Entry<FollowedChild, PlanNetWork> child : children.entrySet()) {
            open.put(path(child.getKey().place()), child.getKey().open());
            open.putAll(child.getValue().open());
        }
        return open;
    }

    /** All places of the net that stand for the mission and its sub-missions. */
    @Override
    public List<Integer> owned() {
        List<Integer> all = new ArrayList<>(places.owned());
        children.values().forEach(child -> all.addAll(child.owned()));
        return all;
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

    @Override
    public PossibleTokens possible() {
        return possible;
    }

    @Override
    public MissionPlaces places() {
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

    /** A case of a firing, with the path to the sub-mission that does it. */
    PlanNetFiring firing(Transition t, List<String> named, List<PlanNetMove> moves, boolean ends) {
        if (path.isEmpty()) {
            return new PlanNetFiring(t.id(), named, moves, ends);
        }
        return new PlanNetFiring(
                path + t.id(),
                named,
                moves.stream()
                        .map(move -> new PlanNetMove(move.token(), behind(move.from()), behind(move.to())))
                        .toList(),
                false);
    }

    private String behind(String place) {
        return place.isEmpty() ? "" : path + place;
    }

    PetriNet build() {
        return net.build();
    }
}
