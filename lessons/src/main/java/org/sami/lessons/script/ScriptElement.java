package org.sami.lessons.script;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.WaitFor;

/**
 * An element of a script: one edit of the plan that is open. What depends on the words of a domain, such as values, is kept as it stands and read
 * when the edit is made. docs/writing-a-lesson.md lists the members.
 */
public sealed interface ScriptElement {
    /** A sentence that is shown while it is done. */
    Optional<String> say();

    /** What it does and to what, in a few words, such as {@code connect p1 > t1}. */
    String title();

    /**
     * Adds an item of the palette.
     *
     * @param item id of the palette
     * @param at where a new vertex is drawn
     * @param on the vertex that gets it; empty draws a new one
     * @param id of the new vertex; with {@code on}, of the new event
     * @param name of the new vertex
     * @param event id of the event on a new vertex
     * @param sequence what is drawn with an event: the id of a sequence, or {@code alone}; empty draws what the domain offers first
     */
    record Add(
            String item,
            Optional<LayoutPoint> at,
            Optional<String> on,
            Optional<String> id,
            Optional<String> name,
            Optional<String> event,
            Optional<String> sequence,
            Optional<String> say)
            implements ScriptElement {
        @Override
        public String title() {
            return "add " + item;
        }
    }

    /** Draws an edge. */
    record Connect(String from, String to, Optional<String> id, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "connect " + from + " > " + to;
        }
    }

    /** Gives a vertex another name, or a variable. */
    record Rename(String what, String name, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "rename " + what;
        }
    }

    /** Deletes elements, variables and tasks. */
    record Delete(List<String> what, Optional<String> say) implements ScriptElement {
        public Delete {
            what = List.copyOf(what);
        }

        @Override
        public String title() {
            return "delete " + String.join(", ", what);
        }
    }

    /** Selects elements; changes nothing. */
    record Select(List<String> what, Optional<String> say) implements ScriptElement {
        public Select {
            what = List.copyOf(what);
        }

        @Override
        public String title() {
            return "select " + String.join(", ", what);
        }
    }

    /** Moves a vertex. */
    record Move(String what, LayoutPoint at, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "move " + what;
        }
    }

    /** Makes a place the start. */
    record Start(String what, boolean on, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "start " + what;
        }
    }

    /**
     * Makes a place an end, or an ordinary place.
     *
     * @param endsSharedInstance of an end: whether it ends the instance that all share
     */
    record End(String what, boolean on, boolean endsSharedInstance, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "end " + what;
        }
    }

    /** Draws elements as nominal or as recovery parts. */
    record InMode(List<String> what, Mode mode, Optional<String> say) implements ScriptElement {
        public InMode {
            what = List.copyOf(what);
        }

        @Override
        public String title() {
            return "mode " + String.join(", ", what);
        }
    }

    /** Says for what a transition waits. */
    record Waiting(String what, WaitFor waitFor, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "wait-for " + what;
        }
    }

    /**
     * Sets all requirements of an edge.
     *
     * @param edge its id, or {@code from>to}
     */
    record Require(String edge, JsonNode requirements, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "require " + edge;
        }
    }

    /**
     * Says from where a field of an output event comes.
     *
     * @param source empty clears it
     */
    record Field(String event, String field, Optional<JsonNode> source, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "field " + field + " of " + event;
        }
    }

    /**
     * Says into which variable a field is written.
     *
     * @param variable empty clears it
     */
    record Write(String event, String field, Optional<String> variable, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "write " + field + " of " + event;
        }
    }

    /** Sets all values by which an input event is selected. */
    record SelectBy(String event, JsonNode fields, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "select-by " + event;
        }
    }

    /**
     * Declares a variable of the plan, or gives it another type or first value.
     *
     * @param declaration its name, type and first value, as in a plan file
     */
    record Variable(String name, JsonNode declaration, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "variable " + name;
        }
    }

    /**
     * Gives an event a markup, or takes it away.
     *
     * @param markup its type and options, as in a plan file
     */
    record Markup(String event, String type, JsonNode markup, boolean on, Optional<String> say)
            implements ScriptElement {
        @Override
        public String title() {
            return "markup " + type + " of " + event;
        }
    }

    /** Changes how a sub-mission is run; what is not given stays. */
    record SubMission(
            String what,
            Optional<Boolean> shared,
            Optional<Map<String, String>> tasks,
            Optional<Map<String, String>> variables,
            Optional<String> say)
            implements ScriptElement {
        @Override
        public String title() {
            return "sub-mission " + what;
        }
    }

    /**
     * Adds a task of the plan, or changes the one of that name.
     *
     * @param task its name, class and fields, as in a plan file
     */
    record Task(String name, JsonNode task, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "task " + name;
        }
    }

    /** Adds a plan to the project and opens it. */
    record NewPlan(String id, String name, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "plan " + id;
        }
    }

    /** Opens another plan of the project. */
    record OpenPlan(String id, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "plan " + id;
        }
    }

    /** Gives a command of the window; without one, {@code undo} and {@code redo} are done and others change nothing. */
    record Give(String id, Optional<String> say) implements ScriptElement {
        @Override
        public String title() {
            return "command " + id;
        }
    }
}
