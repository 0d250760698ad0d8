package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledProject;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * Everything that an engine knows between two steps: missions with their markings, visits, pending occurrences, timers,
 * decisions, variables. Rules change it in place; owned by one thread at a time.
 */
public final class NetState {
    /** The project with which the session began: that of the engine. */
    public final CompiledProject first;

    public long now;
    public long lastMission;
    public long lastActivation;
    public long lastVisit;
    public long lastDecision;
    public long lastTimer;
    public long firings;
    /** Order of the last entry of a token into a place; never used outside. */
    public long stamp;
    /** Number of the present chain of firings without new input; not part of what is kept. */
    public long chain;

    public final Map<Long, MissionState> missions;
    public final ById<SentActivation> sent;
    public final Map<Long, OpenDecision> decisions = new LinkedHashMap<>();
    public final TreeSet<RunningTimer> timers = new TreeSet<>();
    public final SharedValues<Value> globals;
    /** What handlers remember for the session, whatever missions run. */
    public final SharedValues<Value> memory;
    /** How many occurrences of coalesced types that nothing waited for were counted instead of noted. */
    public final SharedValues<Long> discardedNews;

    /** The known robots and their tokens, in the order in which they came; replaced, never changed, so that copies of the state share it. */
    private Map<String, Token.Proxy> robots = Map.of();

    private CompiledProject newest;

    /**
     * Missions whose plans have an input event of a type, by number of the type; in order of their start. Null until one is asked for: most answers
     * go straight to the mission that asked.
     */
    private @Nullable List<Map<Long, MissionState>> attentive;

    public NetState(CompiledProject project) {
        this.first = project;
        this.newest = project;
        missions = new LinkedHashMap<>();
        sent = new ById<>();
        globals = new SharedValues<>();
        memory = new SharedValues<>();
        discardedNews = new SharedValues<>();
        project.project.globals().forEach(v -> v.initial().ifPresent(value -> globals.put(v.name(), value)));
    }

    /** The same projects and robots as another state's, the same numbers and values, and no missions yet. */
    NetState(NetState other) {
        first = other.first;
        newest = other.newest;
        robots = other.robots;
        now = other.now;
        lastMission = other.lastMission;
        lastActivation = other.lastActivation;
        lastVisit = other.lastVisit;
        lastDecision = other.lastDecision;
        lastTimer = other.lastTimer;
        firings = other.firings;
        stamp = other.stamp;
        missions = new LinkedHashMap<>(2 * other.missions.size());
        sent = new ById<>(other.sent.size() + 1); // the step that follows asks for something, mostly
        globals = other.globals.copy();
        memory = other.memory.copy();
        discardedNews = other.discardedNews.copy();
    }

    /** The ids of the known robots, in the order in which they came. */
    public Set<String> proxies() {
        return robots.keySet();
    }

    /** The tokens of the known robots, in the same order. */
    public Collection<Token.Proxy> proxyTokens() {
        return robots.values();
    }

    /** Some robots are known from now on. */
    public void addProxies(Collection<String> ids) {
        Map<String, Token.Proxy> more = new LinkedHashMap<>(robots);
        ids.forEach(id -> more.putIfAbsent(id, new Token.Proxy(id)));
        robots = Collections.unmodifiableMap(more);
    }

    /** A robot is known no longer; says whether it was. */
    public boolean removeProxy(String id) {
        if (!robots.containsKey(id)) {
            return false;
        }
        Map<String, Token.Proxy> left = new LinkedHashMap<>(robots);
        left.remove(id);
        robots = Collections.unmodifiableMap(left);
        return true;
    }

    /** The project whose plans missions have that start from now on. Knows the types of all versions before it. */
    public CompiledProject newest() {
        return newest;
    }

    /** Missions that start from now on have the plans of this project; globals that nothing declares any longer are gone. */
    public void load(CompiledProject loaded) {
        newest = loaded;
        attentive = null;
        forgetGlobals();
    }

    /** The projects whose plans missions run, in the order of these missions; without the newest where no mission runs of it. */
    public Set<CompiledProject> running() {
        Set<CompiledProject> running = new LinkedHashSet<>();
        missions.values().forEach(m -> running.add(m.plan.project));
        return running;
    }

    /** A global lives as long as the newest project or that of a running mission declares it. */
    private void forgetGlobals() {
        Set<CompiledProject> running = running();
        globals.removeIf(name ->
                !newest.globals.containsKey(name) && running.stream().noneMatch(p -> p.globals.containsKey(name)));
    }

    public void add(MissionState mission) {
        missions.put(mission.id, mission);
        if (attentive != null) {
            listen(mission, attentive);
        }
        if (mission.parent != null) {
            mission.parent.addChild(mission);
        }
    }

    public void remove(MissionState mission) {
        missions.remove(mission.id);
        if (attentive != null) {
            for (int type : mission.plan.inputTypes) {
                attentive.get(type).remove(mission.id);
            }
        }
        if (mission.parent != null) {
            mission.parent.children.remove(mission.id);
        }
        if (mission.plan.project != newest) {
            forgetGlobals();
        }
    }

    /** Missions with a transition for that type. */
    public Map<Long, MissionState> attentive(int typeId) {
        if (typeId < 0) {
            return Map.of();
        }
        if (attentive == null) {
            attentive = new ArrayList<>(Collections.nCopies(newest.typeCount(), Map.of()));
            for (MissionState mission : missions.values()) {
                listen(mission, attentive);
            }
        }
        return attentive.get(typeId);
    }

    private static void listen(MissionState mission, List<Map<Long, MissionState>> attentive) {
        for (int type : mission.plan.inputTypes) {
            if (attentive.get(type).isEmpty()) {
                attentive.set(type, new LinkedHashMap<>(4));
            }
            attentive.get(type).put(mission.id, mission);
        }
    }

    /** The open decisions of a mission, in the order in which they were asked; what is closed meanwhile stays in the list. */
    public List<OpenDecision> decisionsOf(MissionState mission) {
        if (mission.decisions.isEmpty()) {
            return List.of();
        }
        List<OpenDecision> open = new ArrayList<>(mission.decisions.size());
        mission.decisions.forEach(id -> open.add(decision(id)));
        return open;
    }

    /** An open decision. */
    public OpenDecision decision(long id) {
        return Objects.requireNonNull(decisions.get(id), "an open decision");
    }

    /** The activation that a timer runs for, or whose question must be answered until then. */
    public SentActivation activationOf(RunningTimer timer) {
        return Objects.requireNonNull(
                timer.isDeadline() ? decision(timer.decision()).sent : sent.get(timer.activation()),
                "a timer's activation");
    }

    /** A task of a running mission, or null. */
    public @Nullable TaskState task(TaskId id) {
        MissionState mission = missions.get(id.mission());
        return mission == null ? null : mission.tasks.get(id.name());
    }
}
