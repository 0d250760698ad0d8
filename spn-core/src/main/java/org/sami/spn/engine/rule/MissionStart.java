package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledOutput;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledPlan;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.Value;

/**
 * Makes missions and instances and gives them their start marking.
 *
 * <p>Implements R-TOK-2, R-ACT-3.
 */
public final class MissionStart {
    private final MissionRules rules;

    public MissionStart(MissionRules rules) {
        this.rules = rules;
    }

    /** Starts a root mission; a reason where it cannot. */
    public Optional<String> start(Input.StartMission input) {
        return start(input, Optional.empty());
    }

    /** Starts a root mission with a marking of its own; a reason where it cannot. */
    public Optional<String> startAt(Input.StartMission input, StartMarking marking) {
        return start(input, Optional.of(marking));
    }

    private Optional<String> start(Input.StartMission input, Optional<StartMarking> marking) {
        CompiledPlan plan = rules.project().plan(input.plan());
        if (plan == null) {
            return Optional.of("There is no plan '" + input.plan() + "'");
        }
        if (plan.start == null) {
            return Optional.of("The plan '" + plan.plan.name() + "' has no start place");
        }
        StartParameters parameters = new StartParameters(rules.step, rules.scopes, plan);
        Optional<String> wrong = parameters.read(input.parameters());
        if (wrong.isPresent()) {
            return wrong;
        }
        if (marking.isPresent()) {
            wrong = StartMarkingCheck.problem(
                            marking.get(), plan.plan, rules.state().proxies())
                    .or(parameters::takeDefaults);
            if (wrong.isPresent()) {
                return wrong;
            }
        }
        MissionState m = make(plan, input.name(), null, null);
        parameters.variables().forEach((name, value) -> rules.scopes.write(m, name, value));
        if (marking.isPresent()) {
            m.parameters = parameters.given();
            begin(m, () -> enter(m, marking.get()));
        } else {
            ask(m, parameters);
        }
        return Optional.empty();
    }

    private void enter(MissionState m, StartMarking marking) {
        for (StartMarking.Tokens at : marking.places()) {
            List<Token> tokens = new ArrayList<>(Collections.nCopies(at.generic(), Token.GENERIC));
            at.proxies().forEach(p -> tokens.add(new Token.Proxy(p)));
            at.tasks().forEach(t -> tokens.add(new Token.Task(m.taskId(t))));
            for (CompiledPlace place : m.plan.places) {
                if (place.id().equals(at.place())) {
                    enter(m, place, tokens);
                }
            }
        }
    }

    /** Makes a mission with its tasks and variables; nothing stands in its places yet. */
    public MissionState make(
            CompiledPlan plan, String name, @Nullable MissionState parent, @Nullable Instance instance) {
        MissionState m = new MissionState(++rules.state().lastMission, plan, name, parent, instance);
        for (VariableSpec v : plan.plan.variables()) {
            v.initial().ifPresent(value -> m.setVariable(v.name(), value));
        }
        m.startedAt = rules.state().now;
        rules.state().add(m);
        rules.emit(started(m));
        for (TaskSpec task : plan.plan.tasks()) {
            m.addTask(new TaskState(m.taskId(task.name()), task.taskClass(), task.fields(), null));
        }
        return m;
    }

    /** The effect of the start of a mission. */
    public static Effect.MissionStarted started(MissionState m) {
        return new Effect.MissionStarted(
                m.id,
                m.parent == null ? Ids.NONE : m.parent.id,
                m.instance == null ? "" : m.instance.place.place.id(),
                m.plan.plan.id(),
                m.name,
                m.plan.project.version);
    }

    /** Asks for what is to be asked, or begins. */
    public void ask(MissionState m, StartParameters parameters) {
        m.parameters = parameters.given();
        if (parameters.mustAsk()) {
            rules.questions.openParameters(m, parameters.items());
        } else {
            begin(m);
        }
    }

    /** All parameters are known: constants, static instances, start marking. */
    public void begin(MissionState m) {
        begin(m, () -> {
            if (m.instance == null) {
                enter(m, rootTokens(m));
            } else {
                List<List<Token>> waiting = m.waiting;
                m.waiting = List.of();
                waiting.forEach(tokens -> enter(m, tokens));
            }
        });
    }

    private void begin(MissionState m, Runnable startMarking) {
        m.status = MissionStatus.RUNNING;
        writeConstants(m);
        rules.sharedInstances.start(m);
        startMarking.run();
    }

    /** Tokens, or nobody, enter the start place. */
    public void enter(MissionState m, List<Token> tokens) {
        enter(m, Objects.requireNonNull(m.plan.start, "a plan without a start place does not start"), tokens);
    }

    private void enter(MissionState m, CompiledPlace place, List<Token> tokens) {
        Visit v = rules.visits.begin(m.place(place.index), tokens);
        rules.activating.activate(v, false);
        rules.subMissions.entered(v);
        rules.work.entered(v.place);
    }

    private List<Token> rootTokens(MissionState m) {
        List<Token> tokens = new ArrayList<>();
        tokens.add(Token.GENERIC);
        tokens.addAll(rules.state().proxyTokens());
        m.tasks.values().forEach(t -> tokens.add(new Token.Task(t.id)));
        return tokens;
    }

    /** Fields that never change write their variables before the start marking. */
    private void writeConstants(MissionState m) {
        for (CompiledPlace place : m.plan.places) {
            for (CompiledOutput output : place.outputs) {
                for (Map.Entry<String, String> write : output.spec.writes().entrySet()) {
                    Value value = constant(m, output, write.getKey());
                    if (value != null) {
                        rules.scopes.write(m, write.getValue(), value);
                    }
                }
            }
        }
    }

    private static @Nullable Value constant(MissionState m, CompiledOutput output, String field) {
        FieldSource source = output.resolved.get(field);
        if (source == null) {
            return output.fixed.get(field);
        }
        return source instanceof FieldSource.Asked ? m.parameters.get(output.spec.id() + "." + field) : null;
    }

    /** Parameters of an instance: what has to be asked of the operator when it is made. */
    public StartParameters parametersOf(CompiledPlan plan) {
        StartParameters parameters = new StartParameters(rules.step, rules.scopes, plan);
        parameters.read(new LinkedHashMap<>());
        return parameters;
    }
}
