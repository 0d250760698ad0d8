package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.TaskId;

/** What the effects of a session have told so far. */
final class Seen {
    private final TreeMap<Integer, Project> projects = new TreeMap<>();
    private final Map<Long, Integer> versions = new LinkedHashMap<>();
    private boolean firstSight;
    final Map<Long, Activation> activations = new LinkedHashMap<>();
    final List<Decision> decisions = new ArrayList<>();
    final Map<Long, Plan> plans = new LinkedHashMap<>();
    final Map<Long, Long> parents = new LinkedHashMap<>();
    final List<TaskId> tasks = new ArrayList<>();
    /** Boats that joined and were not dropped from all. */
    final List<String> joined = new ArrayList<>();

    private final Map<String, Integer> firings = new LinkedHashMap<>();

    Seen(Project project) {
        projects.put(1, project);
    }

    void saw(List<Effect> effects) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated a) {
                activations.put(a.activation().id(), a.activation());
                a.activation().tasks().stream().filter(t -> !tasks.contains(t)).forEach(tasks::add);
            } else if (effect instanceof Effect.DecisionOpened d) {
                decisions.add(d.decision());
            } else if (effect instanceof Effect.ProjectLoaded loaded) {
                firstSight = projects.put(loaded.version(), loaded.project()) == null;
            } else if (effect instanceof Effect.MissionStarted m) {
                plans.put(m.mission(), planOf(m));
                parents.put(m.mission(), m.parent());
                versions.put(m.mission(), m.projectVersion());
            } else if (effect instanceof Effect.Fired f) {
                firings.merge(plans.get(f.mission()).id() + " " + f.transition(), 1, Integer::sum);
            }
        }
    }

    /** A sub-mission's plan is of its parent's project, which may not be the newest. */
    private Plan planOf(Effect.MissionStarted m) {
        return projects.get(m.projectVersion()).plan(m.plan()).orElseThrow();
    }

    /** Whether the project that was loaded last was another than the one before. */
    boolean isFirstSight() {
        return firstSight;
    }

    /** The session's number for the newest project. */
    int newest() {
        return projects.lastKey();
    }

    int versionOf(long mission) {
        return versions.get(mission);
    }

    List<Long> missions() {
        return List.copyOf(plans.keySet());
    }

    boolean isRoot(long mission) {
        return parents.get(mission) == Ids.NONE;
    }

    /** How often a transition of a plan has fired, in all its missions. */
    int firings(Plan plan, String transition) {
        return firings.getOrDefault(plan.id() + " " + transition, 0);
    }

    List<Activation> open(Subject subject) {
        return subject.openActivations().stream().map(activations::get).toList();
    }

    List<Decision> openDecisions(Subject subject) {
        return decisions.stream()
                .filter(d -> subject.openDecisions().contains(d.id()))
                .toList();
    }
}
