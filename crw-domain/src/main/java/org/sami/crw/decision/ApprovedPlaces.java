package org.sami.crw.decision;

import java.util.List;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.Value;

/** What an event asks the operator to approve, as far as it lies on the map: a path of each robot (thesis, Figure 5.6), an area, places. */
final class ApprovedPlaces {
    private ApprovedPlaces() {}

    /** Of the values of its fields those with places, in the order of the fields. */
    static List<Value> of(Activation asking) {
        return asking.values().values().stream()
                .filter(ApprovedPlaces::hasPlaces)
                .toList();
    }

    private static boolean hasPlaces(Value value) {
        if (value instanceof ListValue list) {
            return list.items().stream().anyMatch(ApprovedPlaces::hasPlaces);
        }
        if (value instanceof RecordValue fields) {
            return fields.fields().values().stream().anyMatch(ApprovedPlaces::hasPlaces);
        }
        if (value instanceof MapValue map) {
            return map.entries().values().stream().anyMatch(ApprovedPlaces::hasPlaces);
        }
        return value instanceof GeoPoint || value instanceof GeoPath || value instanceof GeoArea;
    }
}
