package org.sami.lessons.script;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.RenameElement;

/** An edit whose new elements have the ids and names of the script. */
final class NamedEdit {
    private NamedEdit() {}

    /** An edit with others that give what it makes its ids and names: one edit to undo. */
    static Edit of(Edit edit, List<Edit> names) {
        List<Edit> all = new ArrayList<>();
        all.add(edit);
        names.stream()
                .filter(n -> !(n instanceof RenameElement r && r.from().equals(r.to())))
                .forEach(all::add);
        return all.size() == 1 ? edit : new EditSequence(edit.label(), all);
    }
}
