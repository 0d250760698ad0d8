package org.sami.spn.engine.codec;

import java.util.Arrays;
import java.util.Map;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** Says what values mean in facts about the robots and tasks that they name; of points only that they are there. */
final class AlikeValues {
    private final AlikeNames names;
    private final LabelledStructure facts;

    AlikeValues(AlikeNames names, LabelledStructure facts) {
        this.names = names;
        this.facts = facts;
    }

    void all(String what, Map<String, Value> values, int... of) {
        values.forEach((name, value) -> value(what + " " + name, value, of));
    }

    void value(String what, Value value, int... of) {
        if (value instanceof ProxyValue robot) {
            facts.fact(what, and(of, names.robot(robot.proxy())));
        } else if (value instanceof TaskId task) {
            facts.fact(what, and(of, names.task(task)));
        } else if (value instanceof GeoPoint || value instanceof GeoPath) {
            facts.fact(what + " somewhere", of);
        } else if (value instanceof ListValue list) {
            facts.fact(what + " " + list.items().size(), of);
            for (int i = 0; i < list.items().size(); i++) {
                value(what + " " + i, list.items().get(i), of);
            }
        } else if (value instanceof RecordValue record) {
            record.fields().forEach((name, field) -> value(what + "." + name, field, of));
        } else if (value instanceof MapValue map) {
            facts.fact(what + " " + map.entries().size(), of);
            map.entries().forEach((key, entry) -> {
                if (key instanceof ProxyValue robot) {
                    value(what + " to", entry, and(of, names.robot(robot.proxy())));
                } else if (key instanceof TaskId task) {
                    value(what + " to", entry, and(of, names.task(task)));
                } else {
                    value(what + " " + key, entry, of);
                }
            });
        } else {
            facts.fact(what + " = " + value, of);
        }
    }

    private static int[] and(int[] of, int more) {
        int[] all = Arrays.copyOf(of, of.length + 1);
        all[of.length] = more;
        return all;
    }
}
