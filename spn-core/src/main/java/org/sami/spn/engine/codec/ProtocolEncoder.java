package org.sami.spn.engine.codec;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
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
public final class ProtocolEncoder {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final DataOutputStream out = new DataOutputStream(bytes);
    private final ValueEncoder values = new ValueEncoder(this);

    private final LongUnaryOperator missionNumbers;
    private final boolean sorted;

    /** Writes missions by their ids, and maps in their order. */
    public ProtocolEncoder() {
        this(mission -> mission, false);
    }

    private ProtocolEncoder(LongUnaryOperator missionNumbers, boolean sorted) {
        this.missionNumbers = missionNumbers;
        this.sorted = sorted;
    }

    /** Writes the missions of tasks by other numbers, and values in the order of their names: equal ones have equal bytes. */
    static ProtocolEncoder canonical(LongUnaryOperator missionNumbers) {
        return new ProtocolEncoder(missionNumbers, true);
    }

    public byte[] bytes() {
        return bytes.toByteArray();
    }

    public void integer(int n) {
        try {
            out.writeInt(n);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public void number(long n) {
        try {
            out.writeLong(n);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public void real(double d) {
        number(Double.doubleToRawLongBits(d));
    }

    public void flag(boolean b) {
        tag(b ? 1 : 0);
    }

    public void tag(int tag) {
        bytes.write(tag);
    }

    public void text(String s) {
        byte[] utf = s.getBytes(StandardCharsets.UTF_8);
        integer(utf.length);
        bytes.write(utf, 0, utf.length);
    }

    public void texts(Collection<String> texts) {
        integer(texts.size());
        texts.forEach(this::text);
    }

    public void value(Value v) {
        values.write(v);
    }

    void task(TaskId task) {
        text(task.name());
        number(missionNumbers.applyAsLong(task.mission()));
    }

    public void valueList(List<? extends Value> list) {
        integer(list.size());
        list.forEach(this::value);
    }

    public void values(Map<String, Value> map) {
        integer(map.size());
        (sorted ? new TreeMap<>(map) : map).forEach((k, v) -> {
            text(k);
            value(v);
        });
    }

    public void optional(Optional<Value> v) {
        flag(v.isPresent());
        v.ifPresent(this::value);
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

    /** What an activation is given when its place is entered; the rest says its plan. */
    void content(Activation a) {
        values(a.values());
        integer(a.taskValues().size());
        for (Map.Entry<TaskId, Map<String, Value>> e : a.taskValues().entrySet()) {
            value(e.getKey());
            values(e.getValue());
        }
        tokens(a.tokens());
        integer(a.allocation().size());
        a.allocation().forEach((task, proxy) -> {
            value(task);
            text(proxy);
        });
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

    void question(Question q) {
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

    void answer(Answer a) {
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
