package org.sami.dreamm.context;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Project;

/** The plans of a domain's library as one project, in which folders of one label are one. */
public final class LibraryProject {
    private LibraryProject() {}

    /** The project; it has no file. */
    public static Project of(DomainLibrary domain) {
        Project combined = domain.combined();
        return combined.withMissionTree(merged(combined.missionTree()));
    }

    private static List<MissionTreeNode> merged(List<MissionTreeNode> nodes) {
        Map<String, List<MissionTreeNode>> folders = new LinkedHashMap<>();
        for (MissionTreeNode node : nodes) {
            String key = node.plan().map(plan -> "plan " + plan).orElse("folder " + node.label());
            folders.computeIfAbsent(key, each -> new ArrayList<>()).add(node);
        }
        return folders.values().stream()
                .map(same -> same.get(0)
                        .withChildren(merged(same.stream()
                                .flatMap(node -> node.children().stream())
                                .toList())))
                .toList();
    }
}
