package org.sami.spn.engine.codec;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.LongUnaryOperator;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;

/** Writes numbers, texts and values: of a value a tag for its kind, then what it holds. The tags are those of {@link ValueDecoder}. */
public class ValueEncoder {
    private final ByteSink out;
    private final LongUnaryOperator missionNumbers;
    private final boolean sorted;

    /**
     * Writes to the bytes that {@link #bytes} gives.
     *
     * @param missionNumbers what is written for the id of a task's mission
     * @param sorted whether named values are written in the order of their names, and numbers in few bytes
     */
    ValueEncoder(LongUnaryOperator missionNumbers, boolean sorted) {
        this.missionNumbers = missionNumbers;
        this.sorted = sorted;
        out = new ByteSink(sorted);
    }

    public byte[] bytes() {
        return out.toBytes();
    }

    public void integer(int n) {
        out.integer(n);
    }

    public void number(long n) {
        out.number(n);
    }

    public void real(double d) {
        number(Double.doubleToRawLongBits(d));
    }

    public void flag(boolean b) {
        tag(b ? 1 : 0);
    }

    public void tag(int tag) {
        out.octet(tag);
    }

    public void text(String s) {
        out.text(s);
    }

    public void texts(Collection<String> texts) {
        integer(texts.size());
        texts.forEach(this::text);
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
        (sorted && map.size() > 1 ? new TreeMap<>(map) : map).forEach((k, v) -> {
            text(k);
            value(v);
        });
    }

    public void optional(Optional<Value> v) {
        flag(v.isPresent());
        v.ifPresent(this::value);
    }

    public void value(Value v) {
        if (v instanceof BooleanValue b) {
            tag(0);
            flag(b.value());
        } else if (v instanceof IntegerValue i) {
            tag(1);
            number(i.value());
        } else if (v instanceof RealValue r) {
            tag(2);
            real(r.value());
        } else if (v instanceof TextValue t) {
            taggedText(3, t.value());
        } else if (v instanceof DurationValue d) {
            tag(4);
            number(d.millis());
        } else if (v instanceof EnumValue e) {
            taggedText(5, e.type());
            text(e.constant());
        } else if (v instanceof RecordValue r) {
            taggedText(6, r.type());
            values(r.fields());
        } else if (v instanceof ListValue l) {
            tag(7);
            valueList(l.items());
        } else if (v instanceof MapValue m) {
            tag(8);
            integer(m.entries().size());
            m.entries().forEach((key, entry) -> {
                value(key);
                value(entry);
            });
        } else {
            named(v);
        }
    }

    private void named(Value v) {
        if (v instanceof ProxyValue p) {
            taggedText(9, p.proxy());
        } else if (v instanceof TaskId t) {
            tag(10);
            task(t);
        } else if (v instanceof GeoPoint p) {
            tag(11);
            point(p);
        } else if (v instanceof GeoPath p) {
            tag(12);
            points(p.points());
        } else if (v instanceof GeoArea a) {
            tag(13);
            points(a.outline());
            integer(a.holes().size());
            a.holes().forEach(this::points);
        } else if (v instanceof VariableReference r) {
            taggedText(14, r.variable());
        } else if (v instanceof PlanReference r) {
            taggedText(15, r.plan());
        }
    }

    private void taggedText(int tag, String text) {
        tag(tag);
        text(text);
    }

    private void points(List<GeoPoint> points) {
        integer(points.size());
        points.forEach(this::point);
    }

    private void point(GeoPoint p) {
        real(p.latDeg());
        real(p.lonDeg());
        real(p.altM());
    }
}
