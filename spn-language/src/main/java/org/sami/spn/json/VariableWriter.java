package org.sami.spn.json;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.TypeNames;
import org.sami.spn.vocabulary.Vocabulary;

/** Writes the variables that a project or a plan declares. */
final class VariableWriter {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private VariableWriter() {}

    static ArrayNode write(List<VariableSpec> variables, Vocabulary vocabulary) {
        ValueWriter values = new ValueWriter(vocabulary.types());
        ArrayNode array = NODES.arrayNode();
        for (VariableSpec v : variables) {
            ObjectNode node = array.addObject().put("name", v.name()).put("type", TypeNames.of(v.type()));
            v.initial().ifPresent(i -> node.set("initial", values.write(i, v.type())));
        }
        return array;
    }
}
