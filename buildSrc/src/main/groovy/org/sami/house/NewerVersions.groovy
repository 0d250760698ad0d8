package org.sami.house

import org.gradle.api.Project
import org.gradle.api.artifacts.Configuration
import org.gradle.api.artifacts.component.ModuleComponentIdentifier

/**
 * Which libraries have newer releases than the ones in use: those that the version catalog names, and what they bring along to the programs. Asks the repositories of the
 * build for their lists of versions.
 */
class NewerVersions {
    /** A version with one of these words is no release. */
    private static final String NO_RELEASE = /(?i).*[.\-_]?(alpha|beta|rc|cr|m|pr|preview|snapshot|android|jre8|incubating)[.\-_]?\d*.*/

    /** Releases that are left alone, and why: by `group:name`, or `group` for all of it. */
    private final Map<String, String> leftAlone

    NewerVersions(Map<String, String> leftAlone) {
        this.leftAlone = leftAlone
    }

    /** Lines of a table: library, version in use, newest release, and why it is left alone where it is. */
    List<String> behind(Project asking, Collection<String> inUse) {
        def lines = []
        inUse.toUnique().sort().each { coordinates ->
            def (group, name, version) = coordinates.tokenize(':')
            def newest = newestRelease(asking, group, name)
            if (newest == null) {
                lines << String.format('%-60s %-22s newest release unknown: its repository lists none', "$group:$name", version)
            } else if (newest != version) {
                def why = leftAlone["$group:$name".toString()] ?: leftAlone[group]
                lines << String.format('%-60s %-22s %-22s %s', "$group:$name", version, newest, why ?: '').trim()
            }
        }
        return lines
    }

    private static String newestRelease(Project asking, String group, String name) {
        Configuration only = asking.configurations.detachedConfiguration(
            asking.dependencies.create("$group:$name:latest.release@pom"))
        only.transitive = false
        only.resolutionStrategy.componentSelection.all { selection ->
            def version = selection.candidate.version
            if (version ==~ NO_RELEASE && !version.endsWith('-jre')) {
                selection.reject('no release')
            }
        }
        return only.incoming.resolutionResult.allDependencies
            .findAll { it instanceof org.gradle.api.artifacts.result.ResolvedDependencyResult }
            .collect { it.selected.id }
            .findAll { it instanceof ModuleComponentIdentifier }
            .collect { it.version }[0]
    }

    /** What the programs have on their class paths, and what tests and the compiler's checks are made with. */
    static Collection<String> inUse(Collection<Project> projects) {
        projects.collectMany { project ->
            project.configurations.findAll { it.canBeResolved && it.name in ['runtimeClasspath', 'testRuntimeClasspath', 'jmhRuntimeClasspath'] }
                .collectMany { it.incoming.resolutionResult.allComponents }
                .collect { it.id }
                .findAll { it instanceof ModuleComponentIdentifier }
                .collect { "$it.group:$it.module:$it.version".toString() }
        }
    }
}
