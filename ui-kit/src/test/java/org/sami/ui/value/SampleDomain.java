package org.sami.ui.value;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.palette.IdentityMark;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;

/** The shipped domain with some things that are known by name: what editors need to be tried. */
final class SampleDomain {
    static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    static final ComponentChoice CHOICE =
            new ComponentChoice(LIBRARY.components(), LIBRARY.vocabulary().types());
    static final NamedThings NAMES = new NamedThings() {
        @Override
        public List<ChoiceRow> proxies() {
            return List.of(
                    proxy(0, "anna", "82 % · path 3/9 · link 0.2 s"),
                    proxy(1, "bert", "34 % · holding · link 0.1 s"),
                    proxy(2, "carla", "link lost 12 s ago"),
                    proxy(3, "dora", "97 % · idle · link 0.3 s"));
        }

        @Override
        public List<ChoiceRow> tasks() {
            return List.of(task("Temperature 1"), task("Temperature 2"), task("Panorama"));
        }

        @Override
        public List<ChoiceRow> variables() {
            return List.of(
                    new ChoiceRow(new VariableReference("@quay"), "@quay", "point 45.70000, 10.72000"),
                    new ChoiceRow(new VariableReference("@bay"), "@bay", "area of 4 corners"));
        }

        @Override
        public List<ChoiceRow> plans() {
            return List.of(
                    new ChoiceRow(new PlanReference("one"), "Visit locations", ""),
                    new ChoiceRow(new PlanReference("two"), "Keep station", ""));
        }
    };
    static final ValueEditors EDITORS =
            new ValueEditors(CHOICE, new ValueContext(LIBRARY.vocabulary().types(), NAMES, MapMaker.PLAIN));

    private SampleDomain() {}

    private static ChoiceRow proxy(int index, String name, String state) {
        return new ChoiceRow(new ProxyValue(name), name, state, Optional.of(new IdentityMark(index)));
    }

    private static ChoiceRow task(String name) {
        return new ChoiceRow(new TaskId(1, name), name, "");
    }

    static ValueEditor editor(String path, String type) {
        return EDITORS.editor(ValueField.of(path, TypeNames.parse(type).orElseThrow()));
    }

    /** An allocation of two paths, as services answer it. */
    static Value allocation(String method, double totalM) {
        GeoPath path = new GeoPath(
                List.of(GeoPoint.of(45.7, 10.72), GeoPoint.of(45.701, 10.722), GeoPoint.of(45.702, 10.7205)));
        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put(
                "paths",
                new MapValue(Map.of(
                        new ProxyValue("anna"),
                        path,
                        new ProxyValue("bert"),
                        new GeoPath(path.points().subList(0, 2)))));
        fields.put("totalLengthM", new RealValue(totalM));
        fields.put("longestM", new RealValue(totalM * 0.6));
        fields.put("method", new TextValue(method));
        fields.put("reason", new TextValue("Each robot takes the location that is nearest to where it will be then."));
        fields.put("unallocated", new ListValue(List.of()));
        fields.put("tasks", new MapValue(Map.of()));
        return new RecordValue("Allocation", fields);
    }
}
