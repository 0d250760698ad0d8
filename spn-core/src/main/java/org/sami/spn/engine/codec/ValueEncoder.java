package org.sami.spn.engine.codec;

import java.util.List;
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

/** Writes values: a tag for the kind, then what it holds. The tags are those of {@link ValueDecoder}. */
public final class ValueEncoder {
    private final ProtocolEncoder out;

    public ValueEncoder(ProtocolEncoder out) {
        this.out = out;
    }

    public void write(Value v) {
        if (v instanceof BooleanValue b) {
            out.tag(0);
            out.flag(b.value());
        } else if (v instanceof IntegerValue i) {
            out.tag(1);
            out.number(i.value());
        } else if (v instanceof RealValue r) {
            out.tag(2);
            out.real(r.value());
        } else if (v instanceof TextValue t) {
            text(3, t.value());
        } else if (v instanceof DurationValue d) {
            out.tag(4);
            out.number(d.millis());
        } else if (v instanceof EnumValue e) {
            text(5, e.type());
            out.text(e.constant());
        } else if (v instanceof RecordValue r) {
            text(6, r.type());
            out.values(r.fields());
        } else if (v instanceof ListValue l) {
            out.tag(7);
            out.valueList(l.items());
        } else if (v instanceof MapValue m) {
            out.tag(8);
            out.integer(m.entries().size());
            m.entries().forEach((key, value) -> {
                write(key);
                write(value);
            });
        } else {
            writeNamed(v);
        }
    }

    private void writeNamed(Value v) {
        if (v instanceof ProxyValue p) {
            text(9, p.proxy());
        } else if (v instanceof TaskId t) {
            out.tag(10);
            out.task(t);
        } else if (v instanceof GeoPoint p) {
            out.tag(11);
            point(p);
        } else if (v instanceof GeoPath p) {
            out.tag(12);
            points(p.points());
        } else if (v instanceof GeoArea a) {
            out.tag(13);
            points(a.outline());
            out.integer(a.holes().size());
            a.holes().forEach(this::points);
        } else if (v instanceof VariableReference r) {
            text(14, r.variable());
        } else if (v instanceof PlanReference r) {
            text(15, r.plan());
        }
    }

    private void text(int tag, String text) {
        out.tag(tag);
        out.text(text);
    }

    private void points(List<GeoPoint> points) {
        out.integer(points.size());
        points.forEach(this::point);
    }

    private void point(GeoPoint p) {
        out.real(p.latDeg());
        out.real(p.lonDeg());
        out.real(p.altM());
    }
}
