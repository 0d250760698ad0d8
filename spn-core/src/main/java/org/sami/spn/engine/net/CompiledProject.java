package org.sami.spn.engine.net;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Plans of a project in index form, made once: names are resolved here, so that a step only follows references. A session that
 * loads projects has one of each version that something runs of (docs/decisions 0176).
 */
public final class CompiledProject {
    private static final long LEAST_TOKENS_ADDED = 1000;

    public final Vocabulary vocabulary;
    public final Project project;
    public final int livelockLimit;
    /** The session's number for the project; 1 for the one with which it began. */
    public final int version;
    /** By what its document is found again; empty text for the project with which the session began. */
    public final String sha256;

    public final Map<String, VariableSpec> globals = new HashMap<>();
    private final Map<String, Integer> typeIds = new HashMap<>();
    private final List<String> typeNames = new ArrayList<>();
    private final Map<EventRole, String> inputTypeByRole = new HashMap<>();
    private final Map<String, CompiledPlan> plans = new HashMap<>();

    /** The project with which a session begins. */
    public CompiledProject(Vocabulary vocabulary, Project project, int livelockLimit) {
        this(vocabulary, project, livelockLimit, 1, "");
        compile();
    }

    /**
     * A project that is loaded later.
     *
     * @param before the version before it that the session knows: an input event type keeps its number in all versions
     */
    public CompiledProject(CompiledProject before, int version, Project project, String sha256) {
        this(before.vocabulary, project, before.livelockLimit, version, sha256);
        before.typeNames.forEach(this::typeId);
        compile();
    }

    private CompiledProject(Vocabulary vocabulary, Project project, int livelockLimit, int version, String sha256) {
        this.vocabulary = vocabulary;
        this.project = project;
        this.livelockLimit = livelockLimit;
        this.version = version;
        this.sha256 = sha256;
        for (EventType type : vocabulary.events().values()) {
            inputTypeByRole.putIfAbsent(type.role(), type.name());
        }
        project.globals().forEach(v -> globals.put(v.name(), v));
    }

    private void compile() {
        for (Plan plan : project.plans()) {
            plans.putIfAbsent(plan.id(), new CompiledPlan(this, plan));
        }
    }

    /**
     * How many tokens one firing may add: ten for each firing that a chain may have, and a thousand in any case. A firing that would add more
     * halts its mission.
     */
    public long mostTokensAdded() {
        return Math.max(LEAST_TOKENS_ADDED, 10L * livelockLimit);
    }

    /** The plan of that id, or null. */
    public @Nullable CompiledPlan plan(String id) {
        return plans.get(id);
    }

    /** The number of an input event type, by name or alias; given at first sight. */
    public int typeId(String nameOrAlias) {
        String name = vocabulary.event(nameOrAlias).map(EventType::name).orElse(nameOrAlias);
        return typeIds.computeIfAbsent(name, n -> {
            typeNames.add(n);
            return typeNames.size() - 1;
        });
    }

    /** The number of an input event type that some plan of the project speaks of; -1 for others. */
    public int knownTypeId(String nameOrAlias) {
        Integer direct = typeIds.get(nameOrAlias);
        if (direct != null) {
            return direct;
        }
        Optional<EventType> type = vocabulary.event(nameOrAlias);
        Integer id = type.isEmpty() ? null : typeIds.get(type.get().name());
        return id == null ? -1 : id;
    }

    public int typeCount() {
        return typeNames.size();
    }

    /** The input event type with which the engine itself speaks in a role; the role's name where none is declared. */
    public String typeOf(EventRole role) {
        String type = inputTypeByRole.get(role);
        return type == null ? role.name() : type;
    }

    /** The input event type with which the engine answers an output event in a role. */
    public String answerType(CompiledOutput asked, EventRole role) {
        for (String answer : asked.type.map(EventType::answers).orElse(List.of())) {
            if (vocabulary.event(answer).filter(t -> t.role() == role).isPresent()) {
                return answer;
            }
        }
        return typeOf(role);
    }
}
