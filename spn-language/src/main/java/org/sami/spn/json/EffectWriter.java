package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.List;
import java.util.Optional;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Token;
import org.sami.spn.protocol.TokenMove;

/** Writes effects and activations for reports and tools. */
final class EffectWriter {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private EffectWriter() {}

    static ObjectNode write(Effect effect) {
        ObjectNode node = NODES.objectNode();
        if (effect instanceof Effect.Fired e) {
            fired(e, node);
        } else if (effect instanceof Effect.Activated e) {
            node.put("effect", "activated").set("activation", activation(e.activation()));
        } else if (effect instanceof Effect.ActivationEnded e) {
            node.put("effect", "activation-ended").put("activation", e.activation());
        } else if (effect instanceof Effect.MissionStarted e) {
            node.put("effect", "mission-started")
                    .put("mission", e.mission())
                    .put("parent", e.parent())
                    .put("place", e.place())
                    .put("plan", e.plan())
                    .put("name", e.name());
            if (e.projectVersion() > 1) {
                node.put("projectVersion", e.projectVersion());
            }
        } else if (effect instanceof Effect.ProjectLoaded e) {
            node.put("effect", "project-loaded")
                    .put("version", e.version())
                    .put("project", e.project().id());
        } else if (effect instanceof Effect.MissionEnded e) {
            node.put("effect", "mission-ended").put("mission", e.mission()).put("outcome", Words.of(e.outcome()));
        } else if (effect instanceof Effect.DecisionOpened e) {
            node.put("effect", "decision-opened").set("decision", DecisionWriter.write(e.decision()));
        } else if (effect instanceof Effect.DecisionHeld e) {
            node.put("effect", "decision-held").put("decision", e.decision());
        } else if (effect instanceof Effect.DecisionClosed e) {
            node.put("effect", "decision-closed").put("decision", e.decision());
            e.answer().ifPresent(a -> node.set("answer", InputWriter.answer(a)));
            e.by().ifPresent(by -> node.put("by", Words.of(by)));
        } else {
            writeRest(effect, node);
        }
        return node;
    }

    private static void writeRest(Effect effect, ObjectNode node) {
        if (effect instanceof Effect.Entered e) {
            visit(node.put("effect", "entered"), e.mission(), e.place(), e.visit(), e.tokens());
        } else if (effect instanceof Effect.Left e) {
            visit(node.put("effect", "left"), e.mission(), e.place(), e.visit(), e.tokens());
        } else if (effect instanceof Effect.CommandsWithdrawn e) {
            node.put("effect", "commands-withdrawn")
                    .put("mission", e.mission())
                    .set("proxies", InputWriter.texts(e.proxies()));
        } else if (effect instanceof Effect.VariableWritten e) {
            node.put("effect", "variable-written")
                    .put("mission", e.mission())
                    .put("variable", e.variable())
                    .set("value", TaggedValues.write(e.value()));
        } else if (effect instanceof Effect.TasksAllocated e) {
            ArrayNode tasks = node.put("effect", "tasks-allocated")
                    .put("priority", Words.of(e.priority()))
                    .putArray("tasks");
            e.robots().forEach((task, robot) -> {
                ObjectNode entry = tasks.addObject();
                entry.set("task", InputWriter.task(task));
                robot.ifPresent(name -> entry.put("proxy", name));
                Optional.ofNullable(e.before().get(task)).ifPresent(name -> entry.put("before", name));
            });
        } else if (effect instanceof Effect.Noted e) {
            node.put("effect", "noted")
                    .put("kind", Words.of(e.kind()))
                    .put("mission", e.mission())
                    .put("message", e.message());
        } else if (effect instanceof Effect.QuestionAnswered e) {
            node.put("effect", "question-answered")
                    .put("kind", e.kind())
                    .put("about", e.about())
                    .put("yes", e.yes());
            if (!e.proxies().isEmpty()) {
                node.set("proxies", InputWriter.texts(e.proxies()));
            }
        } else {
            throw new IllegalArgumentException("An effect of an unknown kind: " + effect);
        }
    }

    private static void fired(Effect.Fired e, ObjectNode node) {
        node.put("effect", "fired")
                .put("firing", e.firing())
                .put("mission", e.mission())
                .put("transition", e.transition());
        ArrayNode used = node.putArray("used");
        e.used().forEach(o -> used.add(InputWriter.occurrence(o)));
        ArrayNode moves = node.putArray("moves");
        e.moves().forEach(m -> moves.add(move(m)));
    }

    private static void visit(ObjectNode node, long mission, String place, long visit, List<Token> tokens) {
        ArrayNode array = node.put("mission", mission)
                .put("place", place)
                .put("visit", visit)
                .putArray("tokens");
        tokens.forEach(t -> array.add(token(t)));
    }

    private static ObjectNode move(TokenMove move) {
        ObjectNode node = NODES.objectNode();
        node.set("token", token(move.token()));
        move.from().ifPresent(p -> node.put("from", p));
        move.to().ifPresent(p -> node.put("to", p));
        return node;
    }

    static JsonNode token(Token token) {
        if (token instanceof Token.Proxy t) {
            return NODES.objectNode().put("proxy", t.proxy());
        }
        if (token instanceof Token.Task t) {
            return NODES.objectNode().set("task", InputWriter.task(t.task()));
        }
        return TextNode.valueOf("generic");
    }

    static ObjectNode activation(Activation a) {
        ObjectNode node = NODES.objectNode()
                .put("id", a.id())
                .put("mission", a.mission())
                .put("rootMission", a.rootMission())
                .put("visit", a.visit())
                .put("plan", a.plan())
                .put("place", a.place())
                .put("event", a.event())
                .put("type", a.type());
        node.set("values", InputWriter.values(a.values()));
        ArrayNode tasks = node.putArray("taskValues");
        a.taskValues().forEach((task, values) -> {
            ObjectNode entry = tasks.addObject();
            entry.set("task", InputWriter.task(task));
            entry.set("values", InputWriter.values(values));
        });
        ArrayNode tokens = node.putArray("tokens");
        a.tokens().forEach(t -> tokens.add(token(t)));
        ArrayNode allocation = node.putArray("allocation");
        a.allocation().forEach((task, proxy) -> {
            ObjectNode entry = allocation.addObject();
            entry.set("task", InputWriter.task(task));
            entry.put("proxy", proxy);
        });
        node.set("markups", MarkupWriter.write(a.markups()));
        return node.put("priority", Words.of(a.priority()));
    }
}
