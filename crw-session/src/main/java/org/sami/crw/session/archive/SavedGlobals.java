package org.sami.crw.session.archive;

import java.util.List;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.GlobalsFile;

/**
 * What came of saving the values of global variables to a project.
 *
 * @param changes globals that have another initial value in the file now; none where it had these values already
 * @param warnings what was not saved, such as a global that the file does not declare
 */
public record SavedGlobals(List<GlobalsFile.Change> changes, List<Finding> warnings) {
    public SavedGlobals {
        changes = List.copyOf(changes);
        warnings = List.copyOf(warnings);
    }
}
