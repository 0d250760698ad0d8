package org.sami.spn.engine.codec;

import java.util.List;
import java.util.Map;
import java.util.function.LongUnaryOperator;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** Writes messages and what they are made of. */
public final class ProtocolEncoder extends ValueEncoder {
    /** Writes missions by their ids, and maps in their order. */
    public ProtocolEncoder() {
        this(mission -> mission, false);
    }

    private ProtocolEncoder(LongUnaryOperator missionNumbers, boolean sorted) {
        super(missionNumbers, sorted);
    }

    /** Writes the missions of tasks by other numbers, and values in the order of their names: equal ones have equal bytes. */
    static ProtocolEncoder canonical(LongUnaryOperator missionNumbers) {
        return new ProtocolEncoder(missionNumbers, true);
    }

    public void token(Token t) {
        tag(PlacedToken.kindOf(t));
        if (t instanceof Token.Proxy p) {
            text(p.proxy());
        } else if (t instanceof Token.Task task) {
            value(task.task());
        }
    }

    public void tokens(List<Token> tokens) {
        integer(tokens.size());
        tokens.forEach(this::token);
    }

    public void occurrence(Occurrence o) {
        text(o.type());
        number(o.mission());
        number(o.activation());
        texts(o.proxies());
        valueList(o.tasks());
        values(o.values());
    }

    public void activation(Activation a) {
        number(a.id());
        number(a.mission());
        number(a.rootMission());
        number(a.visit());
        text(a.plan());
        text(a.place());
        text(a.event());
        text(a.type());
        content(a);
        markups(a.markups());
        text(a.priority().name());
    }

    /**
     * The content of an activation where the tokens that entered with it are written already.
     *
     * @param entered these tokens: mostly those of the activation, which are then not written again
     */
    void content(Activation a, List<Token> entered) {
        boolean same = a.tokens().equals(entered);
        flag(same);
        fields(a);
        if (!same) {
            tokens(a.tokens());
        }
        allocation(a);
    }

    /** What an activation is given when its place is entered; the rest says its plan. */
    void content(Activation a) {
        fields(a);
        tokens(a.tokens());
        allocation(a);
    }

    private void fields(Activation a) {
        values(a.values());
        integer(a.taskValues().size());
        for (Map.Entry<TaskId, Map<String, Value>> e : a.taskValues().entrySet()) {
            value(e.getKey());
            values(e.getValue());
        }
    }

    private void allocation(Activation a) {
        integer(a.allocation().size());
        a.allocation().forEach((task, proxy) -> {
            value(task);
            text(proxy);
        });
    }

    /** What a decision asks, without its ids and its deadline, which is a timer. */
    void content(Decision d) {
        text(d.type());
        text(d.prompt());
        question(d.question());
        flag(d.automatic().isPresent());
        d.automatic().ifPresent(this::answer);
        text(d.priority().name());
    }

    private void markups(List<MarkupSpec> markups) {
        integer(markups.size());
        for (MarkupSpec m : markups) {
            text(m.type());
            values(m.options());
        }
    }

    public void decision(Decision d) {
        number(d.id());
        number(d.mission());
        number(d.activation());
        text(d.type());
        text(d.prompt());
        question(d.question());
        flag(d.automatic().isPresent());
        d.automatic().ifPresent(this::answer);
        flag(d.deadlineMillis().isPresent());
        d.deadlineMillis().ifPresent(this::number);
        text(d.priority().name());
        markups(d.markups());
    }

    private void question(Question q) {
        if (q instanceof Question.Approve) {
            tag(0);
        } else if (q instanceof Question.ChooseProxies c) {
            tag(1);
            texts(c.proxies());
            integer(c.min());
            integer(c.max());
        } else if (q instanceof Question.ChooseOption c) {
            tag(2);
            valueList(c.options());
        } else if (q instanceof Question.FillIn f) {
            tag(3);
            integer(f.items().size());
            for (Question.Item i : f.items()) {
                text(i.key());
                type(i.type());
                text(i.unit());
                optional(i.defaultValue());
                flag(i.editable());
                text(i.help());
            }
        }
    }

    private void type(ValueType t) {
        if (t instanceof ValueType.Simple s) {
            tag(0);
            text(s.name());
        } else if (t instanceof ValueType.Named n) {
            tag(1);
            text(n.name());
        } else if (t instanceof ValueType.ListOf l) {
            tag(2);
            type(l.element());
        } else if (t instanceof ValueType.MapOf m) {
            tag(3);
            type(m.key());
            type(m.value());
        }
    }

    private void answer(Answer a) {
        if (a instanceof Answer.YesNo y) {
            tag(0);
            flag(y.yes());
        } else if (a instanceof Answer.Proxies p) {
            tag(1);
            texts(p.proxies());
        } else if (a instanceof Answer.Option o) {
            tag(2);
            integer(o.index());
        } else if (a instanceof Answer.Rejected) {
            tag(3);
        } else if (a instanceof Answer.Fields f) {
            tag(4);
            values(f.values());
        }
    }
}
